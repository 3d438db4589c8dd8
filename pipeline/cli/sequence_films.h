// The commands that film several shots as one.
#pragma once

#include "pipeline/cli/commands.h"
#include "pipeline/cli/frames_sheet.h"
#include "pipeline/cli/run_program.h"
#include "pipeline/sequence/sequence_job.h"

namespace carom::cli {

/// The bakes of all shots, each world simulated once. The shots' moments get their times. Throws as
/// obtain_bake does.
[[nodiscard]] pipeline::SequenceBakes obtain_bakes(pipeline::Sequence& sequence,
                                                   const CacheOptions& cache,
                                                   CommandContext& context);

/// Throws InputError if the film cannot be written to the file.
void check_sequence_file(const pipeline::Sequence& sequence, const std::string& path);

/// How many frames the options select; `text` is the range as typed. Throws InputError if there are
/// none.
[[nodiscard]] std::int64_t count_sequence_frames(const pipeline::Sequence& sequence,
                                                 const pipeline::FilmJobOptions& options,
                                                 const std::string& text);

/// As write_frames_sheet for one shot; the pictures are named by their parts.
void write_frames_sheet(const pipeline::Sequence& sequence, const pipeline::SequenceBakes& bakes,
                        const pipeline::FilmJobOptions& options, const FramesSheet& sheet,
                        CommandContext& context);

void render_sequence(const RenderCommand& command, CommandContext& context);
void mux_sequence(const MuxCommand& command, CommandContext& context);
void write_sequence_frame(const FrameCommand& command, CommandContext& context);
void write_sequence_sheet(const ContactSheetCommand& command, CommandContext& context);

}  // namespace carom::cli
