// A picture with frames of a film that is being made.
#include <algorithm>
#include <cstddef>

#include <fmt/core.h>

#include "pipeline/camera/path_fit.h"
#include "pipeline/cli/farm/farm_film.h"
#include "pipeline/sheet/contact_sheet.h"
#include "pipeline/video/picture_kind.h"
#include "pipeline/video/picture_writer.h"
#include "pipeline/video/view_transform.h"

namespace carom::cli {
namespace {

constexpr int kWidth = 320;  // of a picture, pixels, at most
constexpr std::size_t kMost = 16;
constexpr int kColumns = 4;

/// The means of squares of pixels, so that the picture is not wider than kWidth.
pipeline::DisplayPicture reduced(const pipeline::DisplayPicture& picture) {
    const int step = (picture.width + kWidth - 1) / kWidth;
    pipeline::DisplayPicture small{picture.width / step, std::max(1, picture.height / step), {}};
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

/// At most kMost of the frames, at even distances.
std::vector<std::int64_t> spread(const std::vector<std::int64_t>& frames) {
    if (frames.size() <= kMost) {
        return frames;
    }
    std::vector<std::int64_t> some;
    for (std::size_t i = 0; i < kMost; ++i) {
        some.push_back(frames[i * (frames.size() - 1) / (kMost - 1)]);
    }
    return some;
}

}  // namespace

void write_sheet(const FarmFilm& film, const std::vector<std::int64_t>& stored,
                 const std::string& path, CommandContext& context) {
    if (!pipeline::is_picture_path(path) || pipeline::is_linear_picture(path)) {
        throw InputError("cannot write the sheet to '" + path +
                         "'; the name must end in .png, .jpg, .bmp or .tga");
    }
    if (stored.empty()) {
        context.console.info("no frame is finished yet, so there is no sheet");
        return;
    }
    const pipeline::Shot& shot = film.input.shot;
    const pipeline::DisplayView view(shot.output);
    pipeline::FilmJobOptions options = film.options;
    options.renderer = [](const pipeline::FrameInputs&, const WorkContext&,
                          render::FrameSums*) -> render::Film {
        throw Error("a frame disappeared from the store");
    };
    const std::vector<pipeline::CameraRig> rigs =
        pipeline::with_fitted_paths(shot.cameras, film.bake.timeline);
    std::vector<pipeline::SheetCell> cells;
    for (const std::int64_t number : spread(stored)) {
        const render::Film picture =
            pipeline::make_frame(shot, film.bake, number, options, {}, context.stop);
        const pipeline::PlannedFrame frame =
            pipeline::plan_frame(number, rigs, shot.timing, film.bake.timeline);
        cells.push_back(
            {reduced({picture.width, picture.height, view.to_8(picture)}),
             fmt::format("frame {}  scene {:.3f} s  {}", number, frame.scene_time, frame.rig),
             {}});
    }
    const pipeline::DisplayPicture sheet = pipeline::contact_sheet(
        shot.name, fmt::format("{} frames so far", stored.size()), cells, kColumns);
    pipeline::write_display_picture(sheet.rgb, sheet.width, sheet.height, path);
    print_path(path);
}

}  // namespace carom::cli
