#include <string>

#include <fmt/core.h>

#include "pipeline/cli/bake_input.h"
#include "pipeline/cli/output_file.h"
#include "pipeline/cli/run_program.h"
#include "pipeline/cli/shot_input.h"
#include "sim/timeline/bake_file.h"

namespace carom::cli {

void run(const BakeCommand& command, CommandContext& context) {
    if (is_bake_file(command.input.path)) {
        throw InputError("'" + command.input.path +
                         "' is already a bake; give the shot that it was made from");
    }
    const std::string path = output_or_default(command.output, command.input.path, ".bake");
    check_output_folder(path);
    ShotInput input = read_shot_input(command.input, context.console);
    const sim::Bake bake = obtain_bake(input, command.input, command.cache, context);
    sim::write_bake(bake, path);
    context.console.info(fmt::format("{} objects, {} events", bake.timeline.tracks.size(),
                                     bake.timeline.events.size()));
    print_path(path);
}

}  // namespace carom::cli
