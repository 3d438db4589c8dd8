#include <chrono>
#include <string>
#include <utility>

#include "pipeline/cli/bake_input.h"
#include "pipeline/cli/film_commands.h"
#include "pipeline/cli/film_input.h"
#include "pipeline/cli/output_file.h"
#include "pipeline/cli/retime_words.h"
#include "pipeline/cli/run_program.h"
#include "pipeline/cli/shot_input.h"
#include "pipeline/config/load_shot.h"
#include "pipeline/video/video_format.h"

namespace carom::cli {

void run(const RetimeCommand& command, CommandContext& context) {
    const auto begin = std::chrono::steady_clock::now();
    pipeline::RetimeOptions options = parse_retime(command.retime);
    if (!changes_film(command.retime)) {
        throw InputError(
            "no change is given; use --speed, --from, --to, --reverse, --ramp or --rig");
    }
    ShotInput input = read_film_input(command.render.input, FileReading::usual, context);
    if (names_moments(command.retime) || pipeline::has_open_moments(input.shot)) {
        know_motion(input, command.render.input, command.render.cache, context);
    }
    retime(command.retime, std::move(options), input);
    const std::string path =
        output_or_default(command.render.output, command.render.input.path,
                          "_retimed" + pipeline::default_extension(input.shot.output));
    film_shot(std::move(input), path, command.render, begin, context);
}

}  // namespace carom::cli
