#include "lab/cli/compare_triangles.h"

#include <chrono>

#include "lab/cli/kernel_data.h"
#include "lab/comparison/kernel_names.h"
#include "lab/comparison/kernel_plot.h"
#include "lab/comparison/kernel_text.h"
#include "pipeline/cli/drawing_output.h"
#include "pipeline/cli/output_file.h"
#include "pipeline/cli/terminal/progress_meter.h"

namespace carom::cli {

namespace {

using render::triangle::KernelMeasurements;
using render::triangle::MeasureOptions;

MeasureOptions options_of(const CompareCommand& command) {
    MeasureOptions options;
    options.rounds = command.rounds;
    try {
        options.kernels = pipeline::kernels_from_text(command.triangles);
        options.techniques = pipeline::techniques_from_text(command.techniques);
    } catch (const Error& error) {
        throw InputError(error.what());
    }
    if (command.compilers == "both") {
        options.libraries.push_back(render::triangle::other_kernels());
    }
    return options;
}

double now() {
    const auto time = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double>(time).count();
}

KernelMeasurements measure(const MeasureOptions& options, CommandContext& context) {
    ProgressMeter meter;
    WorkContext work;
    work.stop = context.stop;
    work.progress = [&](double fraction) {
        meter.on_progress("compare", fraction, now());
        context.console.progress(meter.snapshot(now()));
    };
    KernelMeasurements measured = render::triangle::measure_kernels(options, work);
    context.console.end_progress();
    return measured;
}

void write(const CompareCommand& command, const KernelMeasurements& measured) {
    write_text_output(command.output.empty() ? "-" : command.output,
                      command.json ? kernels_json(measured) : pipeline::kernels_text(measured));
    if (!command.csv.empty()) {
        write_text_output(command.csv, kernels_csv(measured));
    }
    if (!command.plot.empty()) {
        write_drawing(
            {command.plot, command.drawing.width},
            pipeline::kernels_plot_svg(measured, page_of(command.drawing.page, command.plot)));
    }
}

}  // namespace

void compare_triangles(const CompareCommand& command, CommandContext& context) {
    const MeasureOptions options = options_of(command);
    check_output_folder(command.output);
    check_output_folder(command.csv);
    if (!command.plot.empty()) {
        check_drawing_path(command.plot, "a plot");
    }
    const KernelMeasurements measured = measure(options, context);
    if (!measured.errors.empty()) {
        write(command, measured);
    }
    if (!measured.is_whole) {
        throw Stopped();
    }
}

}  // namespace carom::cli
