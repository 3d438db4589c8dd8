#include "pipeline/cli/frames_sheet.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include <fmt/core.h>

#include "pipeline/camera/frame_plan.h"
#include "pipeline/camera/path_fit.h"
#include "pipeline/job/frame_graphics.h"
#include "pipeline/job/viewed_frame.h"
#include "pipeline/plan/plan_colours.h"
#include "pipeline/sheet/contact_sheet.h"
#include "pipeline/video/picture_kind.h"
#include "pipeline/video/picture_writer.h"
#include "pipeline/video/view_transform.h"

namespace carom::cli {
namespace {

using pipeline::DisplayPicture;
using pipeline::PlannedFrame;
using pipeline::Shot;

std::array<std::uint8_t, 3> colour_of(const Shot& shot, const std::string& rig) {
    const auto found = std::ranges::find(shot.cameras, rig, &pipeline::CameraRig::name);
    const std::string text =
        pipeline::rig_colour(static_cast<std::size_t>(found - shot.cameras.begin()));
    const auto channel = [&](std::size_t at) {
        return static_cast<std::uint8_t>(std::stoi(text.substr(at, 2), nullptr, 16));
    };
    return {channel(1), channel(3), channel(5)};
}

std::string line_of(const PlannedFrame& frame) {
    return fmt::format("frame {}  scene {:.3f} s  {}", frame.number, frame.scene_time, frame.rig);
}

}  // namespace

DisplayPicture reduced(const DisplayPicture& picture, int most_width) {
    const int step = (picture.width + most_width - 1) / most_width;
    DisplayPicture small{picture.width / step, std::max(1, picture.height / step), {}};
    const auto at = [&](int x, int y, int channel) {
        return picture.rgb[3 * (static_cast<std::size_t>(std::min(y, picture.height - 1)) *
                                    static_cast<std::size_t>(picture.width) +
                                static_cast<std::size_t>(x)) +
                           static_cast<std::size_t>(channel)];
    };
    for (int y = 0; y < small.height; ++y) {
        for (int x = 0; x < small.width; ++x) {
            for (int channel = 0; channel < 3; ++channel) {
                int sum = 0;
                for (int i = 0; i < step * step; ++i) {
                    sum += at(x * step + i % step, y * step + i / step, channel);
                }
                small.rgb.push_back(static_cast<std::uint8_t>(sum / (step * step)));
            }
        }
    }
    return small;
}

pipeline::FrameRange spread_frames(std::int64_t count, std::int64_t all) {
    pipeline::FrameRange range;
    const std::int64_t steps = std::min(count, all);
    for (std::int64_t i = 0; i < steps; ++i) {
        const std::int64_t frame = steps == 1 ? 0 : (i * (all - 1) + (steps - 1) / 2) / (steps - 1);
        range.parts.push_back({frame, frame, 1});
    }
    return range;
}

void check_sheet_path(const std::string& path, const std::string& what) {
    if (!pipeline::is_picture_path(path) || pipeline::is_linear_picture(path)) {
        throw InputError("cannot write " + what + " to '" + path +
                         "'; the name must end in .png, .jpg, .bmp or .tga");
    }
}

void write_frames_sheet(const Shot& shot, const sim::Bake& bake,
                        const pipeline::FilmJobOptions& options, const FramesSheet& sheet,
                        CommandContext& context) {
    const pipeline::DisplayView view(shot.output);
    const std::vector<pipeline::CameraRig> rigs =
        pipeline::with_fitted_paths(shot.cameras, bake.timeline);
    pipeline::FrameGraphics graphics(shot, bake.timeline, options.threads);
    std::vector<pipeline::SheetCell> cells;
    for (const std::int64_t number : sheet.frames) {
        const render::Film film =
            pipeline::make_frame(shot, bake, number, options, {}, context.stop);
        const std::vector<PlannedFrame> layers =
            pipeline::plan_mixed_frame(number, rigs, shot.timing, bake.timeline);
        DisplayPicture picture{film.width, film.height,
                               view.to_8(film, pipeline::viewed_frame(layers))};
        graphics.draw_annotations(layers, picture.rgb, film.width, film.height);
        cells.push_back({reduced(picture, sheet.most_width), line_of(layers.front()),
                         colour_of(shot, layers.front().rig)});
    }
    const DisplayPicture picture =
        pipeline::contact_sheet(shot.name, sheet.facts, cells, sheet.columns);
    pipeline::write_display_picture(picture.rgb, picture.width, picture.height, sheet.path);
    print_path(sheet.path);
}

}  // namespace carom::cli
