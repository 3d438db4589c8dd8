#include "pipeline/cli/light_commands.h"

#include <string>

#include "pipeline/cli/bake_input.h"
#include "pipeline/cli/output_file.h"
#include "pipeline/cli/shot_input.h"
#include "pipeline/export/timeline_csv.h"
#include "pipeline/video/video_format.h"
#include "sim/timeline/bake_file.h"

namespace carom::cli {

namespace {

/// A bake's own timeline, or that of a shot.
sim::Timeline timeline_of(const InputOptions& input, const CacheOptions& cache,
                          CommandContext& context) {
    if (is_bake_file(input.path)) {
        return read_bake_input(input.path).timeline;
    }
    return bake_of(read_shot_input(input, context.console).shot, input.path, cache, context)
        .timeline;
}

}  // namespace

void run_check(const CheckCommand& command, CommandContext& context) {
    const ShotInput input = read_shot_input(command.input, context.console);
    const pipeline::Shot& shot = input.shot;
    const std::string film = shot.name + pipeline::default_extension(shot.output);
    const std::string problem = pipeline::check_video_format(
        {shot.render.width, shot.render.height, shot.timing.fps}, shot.output, film);
    if (!problem.empty()) {
        throw InputError("'" + command.input.path + "': " + problem);
    }
    context.console.info("'" + command.input.path + "' has no errors");
}

void run_bake(const BakeCommand& command, CommandContext& context) {
    if (is_bake_file(command.input.path)) {
        throw InputError("'" + command.input.path + "' is a bake already; give the shot");
    }
    const std::string path = output_or_default(command.output, command.input.path, ".bake");
    check_output_folder(path);
    const ShotInput input = read_shot_input(command.input, context.console);
    const sim::Bake bake = bake_of(input.shot, command.input.path, command.cache, context);
    sim::write_bake(bake, path);
    context.console.info(std::to_string(bake.timeline.tracks.size()) + " objects, " +
                         std::to_string(bake.timeline.events.size()) + " events");
    print_path(path);
}

void run_export(const ExportCommand& command, CommandContext& context) {
    // Someone who asks for the events alone gets them alone.
    const bool tracks_wanted = !command.output.empty() || command.events.empty();
    const std::string path = output_or_default(command.output, command.input.path, ".csv");
    if (tracks_wanted) {
        if (path == command.events) {
            throw InputError("'" + path + "' cannot hold both the tracks and the events");
        }
        check_output_folder(path);
    }
    check_output_folder(command.events);

    const sim::Timeline timeline = timeline_of(command.input, command.cache, context);
    if (tracks_wanted) {
        write_text_output(path, command.rate ? pipeline::samples_to_csv(timeline, *command.rate)
                                             : pipeline::keys_to_csv(timeline));
    }
    if (!command.events.empty()) {
        write_text_output(command.events, pipeline::events_to_csv(timeline));
    }
}

}  // namespace carom::cli
