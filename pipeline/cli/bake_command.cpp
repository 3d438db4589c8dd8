#include <string>
#include <vector>

#include <fmt/core.h>
#include <unistd.h>

#include "pipeline/cli/bake_input.h"
#include "pipeline/cli/output_file.h"
#include "pipeline/cli/run_program.h"
#include "pipeline/cli/shot_input.h"
#include "sim/timeline/bake_file.h"

namespace carom::cli {

namespace {

void write_to_pipe(const sim::Bake& bake) {
    if (isatty(STDOUT_FILENO) == 1) {
        throw InputError("a bake is not text for a terminal; pipe it into another command");
    }
    const std::vector<std::byte> bytes = sim::encode_bake(bake);
    print_text({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

}  // namespace

void run(const BakeCommand& command, CommandContext& context) {
    if (is_bake(command.input)) {
        throw InputError("'" + command.input.path +
                         "' is already a bake; give the shot that it was made from");
    }
    const std::string path = output_or_default(command.output, command.input.path, ".bake");
    check_output_folder(path);
    ShotInput input = read_shot_input(command.input, context.console, Subject::motion);
    const sim::Bake bake =
        obtain_bake(input, command.input, command.cache, context, Subject::motion);
    if (path == "-") {
        write_to_pipe(bake);
    } else {
        sim::write_bake(bake, path);
    }
    context.console.info(fmt::format("{} objects, {} events", bake.timeline.tracks.size(),
                                     bake.timeline.events.size()));
    if (path != "-") {
        print_path(path);
    }
}

}  // namespace carom::cli
