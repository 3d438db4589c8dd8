#include <chrono>

#include <fmt/core.h>

#include "lab/cli/compare_triangles.h"
#include "lab/cli/comparison_data.h"
#include "lab/comparison/comparison.h"
#include "lab/comparison/comparison_plot.h"
#include "lab/comparison/comparison_text.h"
#include "lab/comparison/growth.h"
#include "lab/comparison/growth_text.h"
#include "pipeline/cli/bake_input.h"
#include "pipeline/cli/drawing_output.h"
#include "pipeline/cli/film_input.h"
#include "pipeline/cli/output_file.h"
#include "pipeline/cli/run_program.h"
#include "pipeline/cli/shot_input.h"
#include "pipeline/cli/terminal/progress_meter.h"
#include "pipeline/job/film_plan.h"

namespace carom::cli {

namespace {

using pipeline::Comparison;
using pipeline::GrowingScene;
using pipeline::LaboratoryScene;
using pipeline::ShadowRays;

/// The scene of one frame of a shot.
LaboratoryScene scene_of_shot(const CompareCommand& command, CommandContext& context) {
    ShotInput input = read_shot_input(command.input, context.console);
    const std::int64_t frames = film_frames(input.shot);
    const std::int64_t frame = command.frame.value_or(0);
    if (frame >= frames) {
        throw InputError(fmt::format("frame {} is outside the film, which has the frames 0 to {}",
                                     frame, frames - 1));
    }
    const sim::Bake bake = obtain_bake(input, command.input, command.cache, context);
    const pipeline::FilmSource source(input.shot, bake.timeline);
    pipeline::FrameInputs inputs = source.inputs(frame);
    LaboratoryScene scene;
    scene.name = input.shot.name;
    scene.what = fmt::format("frame {}", frame);
    scene.scene = input.shot.scene;
    scene.tracks = std::move(inputs.tracks);
    scene.frame = inputs.frame;
    scene.settings = input.shot.render;
    scene.settings.aovs.clear();
    return scene;
}

void set_size(LaboratoryScene& scene, const std::string& size) {
    int width = 0;
    int height = 0;
    int used = 0;
    const int found = std::sscanf(size.c_str(), "%5dx%5d%n", &width, &height, &used);
    constexpr int kLeast = 16;
    constexpr int kMost = 16384;
    if (found != 2 || static_cast<std::size_t>(used) != size.size() || width < kLeast ||
        height < kLeast || width > kMost || height > kMost) {
        throw InputError("--size '" + size + "' is not a size of 16 to 16384 pixels, as 160x120");
    }
    scene.settings.width = width;
    scene.settings.height = height;
}

void check_what_is_compared(const CompareCommand& command) {
    if (command.input.path.empty() && command.scene.empty() && command.growth.empty()) {
        throw InputError(
            "there is nothing to compare structures on: give a shot, --scene NAME or --growth "
            "NAME");
    }
    if (command.input.path.empty() &&
        (!command.input.overrides.empty() || !command.input.quality.empty() || command.frame)) {
        throw InputError("--set, --quality and --frame can be used only with a shot");
    }
    check_output_folder(command.output);
    check_output_folder(command.csv);
    if (!command.plot.empty()) {
        check_drawing_path(command.plot, "a plot");
    }
}

pipeline::ComparisonOptions options_of(const CompareCommand& command) {
    pipeline::ComparisonOptions options;
    try {
        options.structures = pipeline::structures_from_text(command.accelerators);
    } catch (const Error& error) {
        throw InputError(error.what());
    }
    if (command.shadow_rays == "closest") {
        options.shadow_rays = {ShadowRays::closest};
    } else if (command.shadow_rays == "both") {
        options.shadow_rays = {ShadowRays::any, ShadowRays::closest};
    }
    options.threads = command.threads;
    return options;
}

double now() {
    const auto time = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double>(time).count();
}

/// The result of `measure`, with its progress displayed.
template <class Measure>
auto with_progress(CommandContext& context, const Measure& measure) {
    ProgressMeter meter;
    auto result = measure([&](std::string_view /*structure*/, double fraction) {
        meter.on_progress("compare", fraction, now());
        context.console.progress(meter.snapshot(now()));
    });
    context.console.end_progress();
    return result;
}

/// The result in every requested form.
struct Texts {
    std::string text, csv, plot;
};

void write_texts(const CompareCommand& command, const Texts& texts) {
    write_text_output(command.output.empty() ? "-" : command.output, texts.text);
    if (!command.csv.empty()) {
        write_text_output(command.csv, texts.csv);
    }
    if (!command.plot.empty()) {
        write_drawing({command.plot, command.drawing.width}, texts.plot);
    }
}

void stop_unless(bool is_whole) {
    if (!is_whole) {
        throw Stopped();
    }
}

void run_growth(const CompareCommand& command, CommandContext& context) {
    pipeline::GrowthOptions options;
    options.structures = options_of(command).structures;
    options.largest = static_cast<std::size_t>(command.largest);
    for (const GrowingScene scene :
         {GrowingScene::spheres, GrowingScene::mesh, GrowingScene::balls}) {
        if (command.growth == name_of(scene)) {
            options.scene = scene;
        }
    }
    const pipeline::Growth growth = with_progress(context, [&](const auto& progress) {
        return pipeline::measure_growth(options, progress, context.stop);
    });
    if (!growth.points.empty()) {
        const auto page = page_of(command.drawing.page, command.plot);
        write_texts(command, {command.json ? growth_json(growth) : pipeline::growth_text(growth),
                              growth_csv(growth), pipeline::growth_plot_svg(growth, page)});
    }
    stop_unless(growth.is_whole);
}

void run_comparison(const CompareCommand& command, CommandContext& context) {
    const pipeline::ComparisonOptions options = options_of(command);
    LaboratoryScene scene = command.scene.empty() ? scene_of_shot(command, context)
                                                  : pipeline::make_laboratory_scene(command.scene);
    if (!command.size.empty()) {
        set_size(scene, command.size);
    }
    const Comparison comparison = with_progress(context, [&](const auto& progress) {
        return pipeline::compare_structures(scene, options, progress, context.stop);
    });
    if (!comparison.rows.empty()) {
        const auto page = page_of(command.drawing.page, command.plot);
        write_texts(
            command,
            {command.json ? comparison_json(comparison) : pipeline::comparison_text(comparison),
             comparison_csv(comparison), pipeline::comparison_plot_svg(comparison, page)});
    }
    stop_unless(comparison.is_whole);
}

}  // namespace

void run(const CompareCommand& command, CommandContext& context) {
    if (!command.triangles.empty()) {
        return compare_triangles(command, context);
    }
    check_what_is_compared(command);
    if (!command.growth.empty()) {
        run_growth(command, context);
    } else {
        run_comparison(command, context);
    }
}

}  // namespace carom::cli
