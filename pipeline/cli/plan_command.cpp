#include "pipeline/cli/plan_command.h"

#include <filesystem>

#include "pipeline/cli/bake_input.h"
#include "pipeline/cli/output_file.h"
#include "pipeline/cli/shot_input.h"
#include "pipeline/plan/plan_svg.h"

namespace carom::cli {

namespace {

pipeline::PlanPage page_of(const std::string& name) {
    return name == "light"  ? pipeline::PlanPage::light
           : name == "dark" ? pipeline::PlanPage::dark
                            : pipeline::PlanPage::automatic;
}

}  // namespace

void run_plan(const PlanCommand& command, CommandContext& context) {
    const std::string path = output_or_default(command.output, command.input.path, ".svg");
    const std::string extension = std::filesystem::path(path).extension().string();
    if (path != "-" && extension != ".svg") {
        throw InputError("'" + path + "': a plan is written as .svg");
    }
    check_output_folder(path);
    const ShotInput input = read_shot_input(command.input, context.console);
    const sim::Timeline timeline =
        input.bake ? input.bake->timeline
                   : bake_of(input.shot, command.input.path, command.cache, context).timeline;
    write_text_output(path, pipeline::plan_svg(input.shot, timeline, {page_of(command.page)}));
}

}  // namespace carom::cli
