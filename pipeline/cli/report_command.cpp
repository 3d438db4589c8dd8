#include "pipeline/cli/bake_input.h"
#include "pipeline/cli/drawing_output.h"
#include "pipeline/cli/output_file.h"
#include "pipeline/cli/report_json.h"
#include "pipeline/cli/run_program.h"
#include "pipeline/cli/shot_input.h"
#include "pipeline/plan/report_plot.h"
#include "pipeline/report/report_of_shot.h"
#include "pipeline/report/report_text.h"

namespace carom::cli {

namespace {

/// `shot` is empty if only the motion is known.
void write_report(const ReportCommand& command, const pipeline::Shot& shot,
                  const sim::Timeline& timeline) {
    const pipeline::ShotReport report = pipeline::report_of_shot(shot, timeline);
    write_text_output(command.output.empty() ? "-" : command.output,
                      command.json ? report_json(report) : pipeline::report_text(report));
}

}  // namespace

void run(const ReportCommand& command, CommandContext& context) {
    check_output_folder(command.output);
    if (command.plot.empty() && is_bake_file(command.input.path)) {
        return write_report(command, {},
                            read_timeline_of_bake(command.input.path, context.console));
    }
    if (!command.plot.empty()) {
        check_drawing_path(command.plot, "a plot");
    }
    ShotInput input = read_shot_input(command.input, context.console);
    const sim::Timeline timeline =
        obtain_bake(input, command.input, command.cache, context).timeline;
    // With --plot and without -o and --json only the plot is written.
    if (command.plot.empty() || !command.output.empty() || command.json) {
        write_report(command, input.shot, timeline);
    }
    if (!command.plot.empty()) {
        write_drawing({command.plot, command.drawing.width},
                      pipeline::report_plot_svg(input.shot, timeline,
                                                page_of(command.drawing.page, command.plot)));
    }
}

}  // namespace carom::cli
