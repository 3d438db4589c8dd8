// A picture with frames of a film that is being made.
#include <cstddef>

#include <fmt/core.h>

#include "pipeline/cli/farm/farm_film.h"
#include "pipeline/cli/frames_sheet.h"
#include "pipeline/cli/sequence_films.h"

namespace carom::cli {
namespace {

constexpr std::size_t kMost = 16;

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

void write_sheet(const FarmFilm& film, const std::vector<std::int64_t>& stored, std::int64_t count,
                 const std::string& path, CommandContext& context) {
    check_sheet_path(path, "the sheet");
    if (stored.empty()) {
        context.console.info("no frame is finished yet, so there is no sheet");
        return;
    }
    pipeline::FilmJobOptions options = film.options;
    options.renderer = [](const pipeline::FrameInputs&, const WorkContext&,
                          render::FrameSums*) -> render::Film {
        throw Error("a frame disappeared from the store");
    };
    FramesSheet sheet;
    sheet.frames = spread(stored);
    sheet.facts = fmt::format("{} of {} frames", stored.size(), count);
    sheet.path = path;
    if (const auto* one = std::get_if<FarmFilm::OneShot>(&film.content)) {
        return write_frames_sheet(one->input.shot, one->bake, options, sheet, context);
    }
    const auto& [sequence, bakes] = std::get<FarmFilm::SeveralShots>(film.content);
    write_frames_sheet(sequence, bakes, options, sheet, context);
}

}  // namespace carom::cli
