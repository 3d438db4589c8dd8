#include <vector>

#include "pipeline/camera/frame_plan.h"
#include "pipeline/cli/bake_input.h"
#include "pipeline/cli/drawing_output.h"
#include "pipeline/cli/output_file.h"
#include "pipeline/cli/report_json.h"
#include "pipeline/cli/run_program.h"
#include "pipeline/cli/shot_input.h"
#include "pipeline/plan/report_plot.h"
#include "pipeline/report/report_of_shot.h"
#include "pipeline/report/report_text.h"
#include "pipeline/sound/film_levels.h"
#include "pipeline/sound/film_scene.h"
#include "sound/mix/heard.h"

namespace carom::cli {

namespace {

/// For each event of the timeline the times of the shot's own film at which it is heard, s.
std::vector<std::vector<double>> heard_times(const pipeline::Shot& shot,
                                             const sim::Timeline& timeline) {
    std::vector<std::vector<double>> times(timeline.events.size());
    const std::int64_t frames = pipeline::frame_count(shot.cameras, shot.timing);
    const sound::SoundScene scene = pipeline::film_scene(shot, timeline, 0, frames);
    sound::list_heard(scene, [&times](const sound::HeardImpact& impact) {
        times[impact.event].push_back(impact.film_time);
    });
    return times;
}

void write_report(const ReportCommand& command, const std::string& text) {
    write_text_output(command.output.empty() ? "-" : command.output, text);
}

}  // namespace

void run(const ReportCommand& command, CommandContext& context) {
    check_output_folder(command.output);
    // A table needs only the motion of a bake; the shot in it is not parsed.
    if (command.plot.empty() && !command.json && is_bake_file(command.input.path)) {
        const sim::Timeline timeline = read_timeline_of_bake(command.input.path, context.console);
        return write_report(command, pipeline::report_text(pipeline::report_of_shot({}, timeline)));
    }
    if (!command.plot.empty()) {
        check_drawing_path(command.plot, "a plot");
    }
    ShotInput input = read_shot_input(command.input, context.console);
    const sim::Timeline timeline =
        obtain_bake(input, command.input, command.cache, context).timeline;
    // With --plot and without -o and --json only the plot is written.
    if (command.plot.empty() || !command.output.empty() || command.json) {
        const pipeline::ShotReport report = pipeline::report_of_shot(input.shot, timeline);
        write_report(command, command.json ? report_json(report, heard_times(input.shot, timeline))
                                           : pipeline::report_text(report));
    }
    if (!command.plot.empty()) {
        write_drawing({command.plot, command.drawing.width},
                      pipeline::report_plot_svg(
                          input.shot, timeline, page_of(command.drawing.page, command.plot),
                          pipeline::film_levels(input.shot, timeline, {{}, context.stop})));
    }
}

}  // namespace carom::cli
