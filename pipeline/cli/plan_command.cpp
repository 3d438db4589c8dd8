#include "pipeline/cli/bake_input.h"
#include "pipeline/cli/drawing_output.h"
#include "pipeline/cli/output_file.h"
#include "pipeline/cli/run_program.h"
#include "pipeline/cli/sequence_input.h"
#include "pipeline/cli/shot_input.h"
#include "pipeline/plan/plan_svg.h"
#include "pipeline/sound/film_levels.h"

namespace carom::cli {

void run(const PlanCommand& command, CommandContext& context) {
    if (is_sequence(command.input)) {
        return plan_sequence(command, context);
    }
    const std::string path = output_or_default(command.output, command.input.path, ".svg");
    check_drawing_path(path, "a plan");
    ShotInput input = read_shot_input(command.input, context.console);
    const sim::Timeline timeline =
        obtain_bake(input, command.input, command.cache, context, Subject::plan).timeline;
    write_drawing(
        {path, command.drawing.width},
        pipeline::plan_svg(input.shot, timeline,
                           {page_of(command.drawing.page, path),
                            pipeline::film_levels(input.shot, timeline, {{}, context.stop})}));
}

}  // namespace carom::cli
