#include "pipeline/cli/sequence_films.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "pipeline/camera/shown_frame.h"
#include "pipeline/cli/bake_input.h"
#include "pipeline/cli/film_input.h"
#include "pipeline/cli/frames_sheet.h"
#include "pipeline/cli/job_observer.h"
#include "pipeline/cli/moment_text.h"
#include "pipeline/cli/output_file.h"
#include "pipeline/cli/sequence_input.h"
#include "pipeline/cli/terminal/duration_text.h"
#include "pipeline/cli/time_text.h"
#include "pipeline/job/film_status.h"
#include "pipeline/video/image_sequence.h"
#include "pipeline/video/picture_kind.h"
#include "pipeline/video/picture_writer.h"
#include "pipeline/video/video_format.h"

namespace carom::cli {

using pipeline::Sequence;
using pipeline::SequenceBakes;
using pipeline::ShotPart;

SequenceBakes obtain_bakes(Sequence& sequence, const CacheOptions& cache, CommandContext& context) {
    SequenceBakes bakes;
    for (std::size_t i = 0; i < sequence.parts.size(); ++i) {
        if (auto* part = std::get_if<ShotPart>(&sequence.parts[i].content)) {
            ShotInput input = input_of(*part);
            bakes[i] = obtain_bake(input, InputOptions{part->path, {}, {}, {}, {}}, cache, context);
            take_back(std::move(input), *part);
        }
    }
    return bakes;
}

void check_sequence_file(const Sequence& sequence, const std::string& path) {
    if (pipeline::is_image_sequence(path)) {
        throw InputError("a film of several shots is written as a video, not as pictures ('" +
                         path + "'); 'carom frame' writes single ones");
    }
    const std::string problem = pipeline::check_video_format(
        {sequence.width, sequence.height, sequence.fps}, sequence.output, path);
    if (!problem.empty()) {
        throw InputError(problem);
    }
    check_output_folder(path);
}

std::int64_t count_sequence_frames(const Sequence& sequence,
                                   const pipeline::FilmJobOptions& options,
                                   const std::string& text) {
    const std::int64_t all = sequence.frames();
    const std::vector<std::int64_t> frames = options.frames.frames(all);
    if (frames.empty()) {
        throw InputError(
            fmt::format("--frames {} selects no frame of the film, which has the frames 0 to {}",
                        text, all - 1));
    }
    return std::ssize(options.chunk.part_of(frames));
}

namespace {

/// Prints how many frames of each part are stored.
void print_status(const Sequence& sequence, const SequenceBakes& bakes,
                  const pipeline::FilmJobOptions& options, CommandContext& context) {
    std::string text;
    for (std::size_t i = 0; i < sequence.parts.size(); ++i) {
        const auto* part = std::get_if<ShotPart>(&sequence.parts[i].content);
        if (part == nullptr) {
            continue;
        }
        const pipeline::FilmStatus status =
            pipeline::part_status(sequence, i, bakes, options, context.stop);
        if (status.frames.empty()) {
            continue;
        }
        text += fmt::format("{}: {} frames, {} stored, {} to render\n", part_name(i, *part),
                            status.frames.size(), status.stored.size(), status.missing.size());
    }
    print_text(text);
}

}  // namespace

void render_sequence(const RenderCommand& command, CommandContext& context) {
    const auto begin = std::chrono::steady_clock::now();
    Sequence sequence = read_checked_sequence(command.input, FileReading::usual, context);
    const bool makes_film = command.chunk.empty();
    const std::string path = makes_film
                                 ? output_or_default(command.output, command.input.path,
                                                     pipeline::default_extension(sequence.output))
                                 : "";
    if (!makes_film && !command.output.empty()) {
        throw InputError("cannot write the film '" + command.output +
                         "' from one chunk; omit -o, and render without --chunk when all chunks "
                         "are done");
    }
    if (makes_film) {
        check_sequence_file(sequence, path);
    }
    pipeline::FilmJobOptions options = job_options(command.cache, command.frames, command.chunk);
    options.output = path;
    options.threads = command.threads;
    options.structures = context.structures;
    const std::int64_t frames = count_sequence_frames(sequence, options, command.frames);
    require_store(options);
    const SequenceBakes bakes = obtain_bakes(sequence, command.cache, context);
    if (command.dry_run) {
        return print_status(sequence, bakes, options, context);
    }
    warn_of_no_store(command.cache, context.console);
    const pipeline::FilmJobResult result = pipeline::make_sequence(
        sequence, bakes, options, make_console_observer(context.console, frames), context.stop);
    context.console.end_progress();
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
    context.console.info(fmt::format("{} frames of {} parts, {} of them rendered now, in ",
                                     result.frames, sequence.parts.size(), result.rendered) +
                         duration_text(elapsed.count()));
    if (makes_film) {
        print_path(path);
    }
}

void mux_sequence(const MuxCommand& command, CommandContext& context) {
    Sequence sequence = read_checked_sequence(command.input, FileReading::usual, context);
    const std::string path = output_or_default(command.output, command.input.path,
                                               pipeline::default_extension(sequence.output));
    check_sequence_file(sequence, path);
    pipeline::FilmJobOptions options = job_options(command.cache, command.frames, {});
    options.output = path;
    options.so_far = command.so_far;
    const std::int64_t frames = count_sequence_frames(sequence, options, command.frames);
    const SequenceBakes bakes = obtain_bakes(sequence, command.cache, context);
    const pipeline::FilmJobResult result = pipeline::mux_sequence(
        sequence, bakes, options, make_console_observer(context.console, frames), context.stop);
    context.console.end_progress();
    context.console.info(
        fmt::format("{} frames of {} parts", result.frames, sequence.parts.size()));
    print_path(path);
}

namespace {

/// The frame of the film that first shows the moment in the part; empty if it does not. Throws
/// InputError if the moment never comes.
std::optional<std::int64_t> frame_in_part(const std::string& text, Sequence& sequence,
                                          std::size_t index, const sim::Bake& bake) {
    auto& part = std::get<ShotPart>(sequence.parts[index].content);
    ShotInput input = input_of(part);
    input.bake = bake;
    std::optional<std::int64_t> frame;
    try {
        const double time = time_of_moment("--at", text, input);
        frame = pipeline::first_frame_showing(time, input.shot.cameras, input.shot.timing);
    } catch (const InputError&) {
        take_back(std::move(input), part);
        throw;
    }
    take_back(std::move(input), part);
    const bool is_shown =
        frame && *frame >= part.first && *frame < part.first + sequence.parts[index].frames;
    return is_shown ? std::optional(sequence.starts()[index] + *frame - part.first) : std::nullopt;
}

/// The first frame that shows the moment, in the first part that does.
std::int64_t frame_at_moment(const std::string& text, Sequence& sequence,
                             const SequenceBakes& bakes) {
    std::string reason = "--at " + text + ": the film does not show that moment";
    for (const auto& [index, bake] : bakes) {
        try {
            if (const auto frame = frame_in_part(text, sequence, index, bake)) {
                return *frame;
            }
        } catch (const InputError& error) {  // the shots have different balls
            reason = error.what();
        }
    }
    throw InputError(reason);
}

std::int64_t chosen_frame(const FrameCommand& command, Sequence& sequence,
                          const SequenceBakes& bakes) {
    const std::int64_t frame =
        is_moment_text(command.at) ? frame_at_moment(command.at, sequence, bakes)
        : command.at.empty()       ? command.frame.value_or(0)
                                   : frame_shown_at(parse_seconds(command.at), sequence.fps);
    if (frame < 0 || frame >= sequence.frames()) {
        throw InputError(fmt::format("frame {} is outside the film, which has the frames 0 to {}",
                                     frame, sequence.frames() - 1));
    }
    return frame;
}

}  // namespace

void write_sequence_frame(const FrameCommand& command, CommandContext& context) {
    Sequence sequence = read_checked_sequence(command.input, FileReading::usual, context);
    SequenceBakes bakes;
    const bool is_moment = is_moment_text(command.at);
    if (is_moment) {
        bakes = obtain_bakes(sequence, command.cache, context);
    }
    const std::int64_t frame = chosen_frame(command, sequence, bakes);
    const std::string path =
        output_or_default(command.output, command.input.path, fmt::format(".{:04}.png", frame));
    check_sheet_path(path, "a frame of several shots");
    check_output_folder(path);
    pipeline::FilmJobOptions options = job_options(command.cache, {}, {});
    options.threads = command.threads;
    options.structures = context.structures;
    if (!is_moment) {
        require_store(options);
        bakes = obtain_bakes(sequence, command.cache, context);
    }
    warn_of_no_store(command.cache, context.console);
    pipeline::for_each_frame(
        sequence, bakes, {frame}, options, make_console_observer(context.console, 1),
        [&](std::int64_t, const pipeline::DisplayPicture& picture) {
            context.console.end_progress();
            pipeline::write_display_picture(picture.rgb, picture.width, picture.height, path);
        },
        context.stop);
    print_path(path);
}

void write_frames_sheet(const Sequence& sequence, const SequenceBakes& bakes,
                        const pipeline::FilmJobOptions& options, const FramesSheet& sheet,
                        CommandContext& context) {
    std::vector<pipeline::SheetCell> cells;
    pipeline::for_each_frame(
        sequence, bakes, sheet.frames, options,
        make_console_observer(context.console, std::ssize(sheet.frames)),
        [&](std::int64_t frame, const pipeline::DisplayPicture& picture) {
            const pipeline::SequenceLayer layer = pipeline::layers_of(sequence, frame).back();
            const auto* part = std::get_if<ShotPart>(&sequence.parts[layer.part].content);
            cells.push_back(
                {reduced(picture, sheet.most_width),
                 fmt::format("frame {}  {}", frame,
                             part != nullptr ? part_name(layer.part, *part)
                                             : fmt::format("part {}, title", layer.part + 1)),
                 {128, 128, 128}});
        },
        context.stop);
    context.console.end_progress();
    const pipeline::DisplayPicture made =
        pipeline::contact_sheet(sequence.name, sheet.facts, cells, sheet.columns);
    pipeline::write_display_picture(made.rgb, made.width, made.height, sheet.path);
    print_path(sheet.path);
}

void write_sequence_sheet(const ContactSheetCommand& command, CommandContext& context) {
    InputOptions input = command.input;
    if (input.quality.empty()) {
        input.quality = "draft";
    }
    FramesSheet sheet;
    sheet.path = output_or_default(command.output, input.path, "_sheet.png");
    check_sheet_path(sheet.path, "a contact sheet");
    check_output_folder(sheet.path);
    Sequence sequence = read_checked_sequence(input, FileReading::usual, context);
    pipeline::FilmJobOptions options = job_options(command.cache, {}, {});
    options.threads = command.threads;
    options.structures = context.structures;
    sheet.frames = spread_frames(command.count, sequence.frames()).frames(sequence.frames());
    sheet.facts =
        fmt::format("{} frames, {:.6g} per second", sequence.frames(), sequence.fps.to_double());
    sheet.columns = command.columns;
    sheet.most_width = command.width;
    require_store(options);
    const SequenceBakes bakes = obtain_bakes(sequence, command.cache, context);
    write_frames_sheet(sequence, bakes, options, sheet, context);
}

}  // namespace carom::cli
