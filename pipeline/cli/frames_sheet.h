// A contact sheet of frames that are in the store.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "pipeline/cli/run_program.h"
#include "pipeline/job/film_job.h"
#include "pipeline/sheet/contact_sheet.h"
#include "pipeline/shot/shot.h"
#include "sim/timeline/bake_file.h"

namespace carom::cli {

struct FramesSheet {
    std::vector<std::int64_t> frames;  // at least one
    std::string facts;                 // at the right of the title
    int columns = 4;
    int most_width = 320;  // pixels of a picture; wider ones are reduced
    std::string path;      // of the file
};

/// Throws InputError if no sheet can be written to a file of this name. `what`: "the sheet".
void check_sheet_path(const std::string& path, const std::string& what);

/// The picture with the means of squares of its pixels, so that it is not wider than `most_width`.
[[nodiscard]] pipeline::DisplayPicture reduced(const pipeline::DisplayPicture& picture,
                                               int most_width);

/// `count` of `all` frames at even distances, with the first and the last one.
[[nodiscard]] pipeline::FrameRange spread_frames(std::int64_t count, std::int64_t all);

/// Writes the frames with their numbers, times and cameras; a mark has the camera's colour on the
/// plan. Frames that are not in the store of `options` are rendered. Prints the path. Throws Error,
/// Stopped.
void write_frames_sheet(const pipeline::Shot& shot, const sim::Bake& bake,
                        const pipeline::FilmJobOptions& options, const FramesSheet& sheet,
                        CommandContext& context);

}  // namespace carom::cli
