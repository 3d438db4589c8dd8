#include <algorithm>
#include <vector>

#include <fmt/core.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "core/text.h"
#include "pipeline/camera/frame_plan.h"
#include "pipeline/cli/bake_input.h"
#include "pipeline/cli/drawing_output.h"
#include "pipeline/cli/output_file.h"
#include "pipeline/cli/report_filter.h"
#include "pipeline/cli/report_json.h"
#include "pipeline/cli/run_program.h"
#include "pipeline/cli/sequence_input.h"
#include "pipeline/cli/shot_input.h"
#include "pipeline/plan/report_plot.h"
#include "pipeline/report/report_of_shot.h"
#include "pipeline/report/report_text.h"
#include "pipeline/sound/film_levels.h"
#include "pipeline/sound/film_scene.h"
#include "sound/mix/auralisation.h"

namespace carom::cli {

namespace {

using pipeline::ShotReport;

/// Tells each event of the timeline when the shot's own film makes it heard.
void add_heard_times(const pipeline::Shot& shot, const sim::Timeline& timeline,
                     ShotReport& report) {
    for (pipeline::ReportedEvent& row : report.events) {
        if (row.event.kind == sim::EventKind::impact || row.event.kind == sim::EventKind::strike) {
            row.heard_at.emplace();
        }
    }
    const std::int64_t frames = pipeline::frame_count(shot.cameras, shot.timing);
    const sound::SoundScene scene = pipeline::film_scene(shot, timeline, 0, frames);
    for (const sound::AudibleImpact& impact : sound::audible_impacts(scene)) {
        report.events[impact.event].heard_at->push_back(impact.film_time);
    }
}

int columns_of_output(const ReportCommand& command) {
    winsize size{};
    constexpr int kMost = 200;
    const bool is_screen =
        command.output.empty() && ::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
    return is_screen
               ? std::clamp(static_cast<int>(size.ws_col), pipeline::kLeastReportColumns, kMost)
               : pipeline::kLeastReportColumns;
}

/// What is wanted of the report, as text or JSON.
std::string text_of(const ReportCommand& command, ShotReport report, const ShotInput& input) {
    const pipeline::ReportParts parts =
        pipeline::apply(report_filter(command, report, input), report);
    return command.json ? report_json(report, parts)
                        : pipeline::report_text(
                              report, {parts, columns_of_output(command), command.every_impact});
}

/// Says of what a large object mostly consists.
void advise_on_size(const ReportCommand& command, const std::string& text, Console& console) {
    constexpr std::size_t kLarge = 200'000;  // bytes
    if (command.json && text.size() > kLarge && command.only.empty() && command.without.empty()) {
        const std::size_t samples = text.size() - text.find("\"energy_over_time\":");
        console.info(fmt::format(
            "the report has {} kB, of which the energy of every sample takes {}; --without "
            "energy_over_time, --only and --without leave parts out",
            text.size() / 1000, samples / 1000));
    }
}

/// Of an input whose bake is known.
std::string report_of(const ReportCommand& command, const ShotInput& input) {
    const sim::Timeline& timeline = input.bake->timeline;
    ShotReport report = pipeline::report_of_shot(input.shot, timeline);
    if (command.json) {
        add_heard_times(input.shot, timeline, report);
    }
    return text_of(command, std::move(report), input);
}

void write_report(const ReportCommand& command, const std::string& text, Console& console) {
    advise_on_size(command, text, console);
    write_text_output(command.output.empty() ? "-" : command.output, text);
}

/// The report of each shot, one after the other, or a list of them.
void report_sequence(const ReportCommand& command, CommandContext& context) {
    if (!command.plot.empty()) {
        throw InputError("--plot draws one shot; give one of those that '" + command.input.path +
                         "' names");
    }
    pipeline::Sequence sequence = read_sequence_input(command.input, context.console);
    std::vector<std::string> reports;
    for (std::size_t i = 0; i < sequence.parts.size(); ++i) {
        auto* part = std::get_if<pipeline::ShotPart>(&sequence.parts[i].content);
        if (part == nullptr) {
            continue;
        }
        ShotInput input = input_of(*part);
        const InputOptions options{part->path, {}, {}, {}, {}};
        input.bake = obtain_bake(input, options, command.cache, context, Subject::motion);
        reports.push_back((command.json ? "" : part_name(i, *part) + "\n") +
                          report_of(command, input));
    }
    write_report(command, command.json ? "[" + join(reports, ",\n") + "]\n" : join(reports, "\n"),
                 context.console);
}

}  // namespace

void run(const ReportCommand& command, CommandContext& context) {
    check_output_folder(command.output);
    if (is_sequence(command.input)) {
        return report_sequence(command, context);
    }
    // A table needs only the motion of a bake; the shot in it is not parsed.
    if (command.plot.empty() && !command.json && !names_moments(command) &&
        is_bake(command.input)) {
        const sim::Timeline timeline = read_timeline_of_bake(command.input, context.console);
        return write_report(command, text_of(command, pipeline::report_of_shot({}, timeline), {}),
                            context.console);
    }
    if (!command.plot.empty()) {
        check_drawing_path(command.plot, "a plot");
    }
    ShotInput input = read_shot_input(command.input, context.console, Subject::motion);
    input.bake = obtain_bake(input, command.input, command.cache, context, Subject::motion);
    // With --plot and without -o and --json only the plot is written.
    if (command.plot.empty() || !command.output.empty() || command.json) {
        write_report(command, report_of(command, input), context.console);
    }
    if (!command.plot.empty()) {
        const sim::Timeline& timeline = input.bake->timeline;
        write_drawing({command.plot, command.drawing.width},
                      pipeline::report_plot_svg(
                          input.shot, timeline, page_of(command.drawing.page, command.plot),
                          pipeline::film_levels(input.shot, timeline, {{}, context.stop})));
    }
}

}  // namespace carom::cli
