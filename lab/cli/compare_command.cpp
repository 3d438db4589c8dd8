#include <algorithm>
#include <charconv>
#include <chrono>
#include <sstream>

#include <fmt/core.h>

#include "lab/cli/report_data.h"
#include "lab/comparison/kernel_names.h"
#include "lab/comparison/lane_limit.h"
#include "lab/comparison/reports.h"
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

using pipeline::LaboratoryScene;
using pipeline::ShadowRays;
using render::VariedSize;

void check_outputs(const CompareCommand& command) {
    check_output_folder(command.output);
    check_output_folder(command.csv);
    if (!command.plot.empty()) {
        check_drawing_path(command.plot, "a plot");
    }
}

/// Writes the result in every requested form, unless nothing was measured; throws Stopped unless
/// everything was.
template <class Result>
void write_result(const CompareCommand& command, const Result& result, bool is_empty) {
    if (!is_empty) {
        write_text_output(
            command.output.empty() ? "-" : command.output,
            command.json ? report_data(result).json() : pipeline::report_text(result));
    }
    if (!is_empty && !command.csv.empty()) {
        write_text_output(command.csv, report_data(result).csv());
    }
    if (!is_empty && !command.plot.empty()) {
        const auto page = page_of(command.drawing.page, command.plot);
        write_drawing({command.plot, command.drawing.width}, pipeline::report_plot(result, page));
    }
    if (!result.is_whole) {
        throw Stopped();
    }
}

/// Seconds of a clock that never goes back.
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

/// The result of `work`; its Error is one of the user's input.
template <class Work>
auto checked(const Work& work) {
    try {
        return work();
    } catch (const Error& error) {
        throw InputError(error.what());
    }
}

/// The numbers of a list such as "1,2,4", without repetition. `option`: "--leaf-capacity". Throws
/// InputError.
template <class Number>
std::vector<Number> numbers_of(std::string_view option, const std::string& text, Number lowest,
                               Number highest) {
    std::vector<Number> numbers;
    std::istringstream list(text + ",");
    for (std::string word; std::getline(list, word, ',');) {
        Number number = 0;
        const char* const end = word.data() + word.size();
        const auto read = std::from_chars(word.data(), end, number);
        const bool is_number = read.ec == std::errc() && read.ptr == end;
        if (!is_number || !(number >= lowest && number <= highest)) {
            throw InputError(fmt::format("{} '{}' is not a list of {}numbers from {} to {}", option,
                                         text, std::is_integral_v<Number> ? "whole " : "", lowest,
                                         highest));
        }
        if (std::ranges::find(numbers, number) != numbers.end()) {
            throw InputError(fmt::format("{} names {} twice", option, number));
        }
        numbers.push_back(number);
    }
    return numbers;
}

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
    if (command.input.path.empty() && command.scene.empty() && command.growth.empty() &&
        !command.motion) {
        throw InputError(
            "there is nothing to compare structures on: give a shot, --scene NAME, --growth NAME "
            "or --motion N");
    }
    if (command.input.path.empty() &&
        (!command.input.overrides.empty() || !command.input.quality.empty() || command.frame)) {
        throw InputError("--set, --quality and --frame can be used only with a shot");
    }
    check_outputs(command);
}

pipeline::ComparisonOptions options_of(const CompareCommand& command) {
    pipeline::ComparisonOptions options;
    options.structures = checked([&] {
        return command.kernel.empty() ? pipeline::structures_from_text(command.accelerators)
                                      : pipeline::structures_with_kernels(command.accelerators);
    });
    if (!command.kernel.empty()) {
        options.kernels = checked([&] { return pipeline::kernels_from_text(command.kernel); });
    }
    if (command.shadow_rays == "closest") {
        options.shadow_rays = {ShadowRays::closest};
    } else if (command.shadow_rays == "both") {
        options.shadow_rays = {ShadowRays::any, ShadowRays::closest};
    }
    options.threads = command.threads;
    return options;
}

/// The size that is varied, and its values; none if no size is.
struct SizeList {
    VariedSize size = VariedSize::leaf_capacity;
    std::vector<double> values;
};

SizeList sizes_of(const CompareCommand& command) {
    const auto whole = [](std::string_view option, const std::string& text, int lowest) {
        const std::vector<int> numbers = numbers_of(option, text, lowest, 1024);
        return std::vector<double>(numbers.begin(), numbers.end());
    };
    if (!command.leaf_capacity.empty()) {
        return {VariedSize::leaf_capacity, whole("--leaf-capacity", command.leaf_capacity, 1)};
    }
    if (!command.node_capacity.empty()) {
        return {VariedSize::node_capacity, whole("--node-capacity", command.node_capacity, 2)};
    }
    if (!command.grid_density.empty()) {
        return {VariedSize::grid_density,
                numbers_of("--grid-density", command.grid_density, 0.001, 1000.0)};
    }
    return {};
}

std::vector<int> lanes_of(const CompareCommand& command) {
    if (command.lanes.empty()) {
        return {};
    }
    std::vector<int> all = numbers_of("--lanes", command.lanes, 4, 16);
    for (const int lanes : all) {
        if (lanes != 4 && lanes != 8 && lanes != 16) {
            throw InputError("--lanes '" + command.lanes + "' names others than 4, 8 and 16");
        }
        if (!pipeline::LaneLimit::machine_has(lanes)) {
            throw InputError(fmt::format("this processor has no vectors of {} numbers", lanes));
        }
    }
    return all;
}

void run_growth(const CompareCommand& command, CommandContext& context) {
    pipeline::GrowthOptions options;
    options.structures = options_of(command).structures;
    options.largest = static_cast<std::size_t>(command.largest);
    options.lanes = lanes_of(command);
    for (const pipeline::GrowingSceneFacts& known : pipeline::growing_scenes()) {
        if (command.growth == known.name) {
            options.scene = known.scene;
        }
    }
    const pipeline::Growth growth = with_progress(context, [&](const auto& progress) {
        return pipeline::measure_growth(options, progress, context.stop);
    });
    write_result(command, growth, growth.points.empty());
}

void run_motion(const CompareCommand& command, CommandContext& context) {
    pipeline::MotionOptions options;
    options.structures = options_of(command).structures;
    options.balls = static_cast<std::size_t>(*command.motion);
    if (!command.intervals.empty()) {
        options.intervals = numbers_of("--intervals", command.intervals, 1, 1000);
    }
    const pipeline::Motion motion = with_progress(context, [&](const auto& progress) {
        return pipeline::measure_motion(options, progress, context.stop);
    });
    write_result(command, motion, motion.points.empty());
}

LaboratoryScene scene_of(const CompareCommand& command, CommandContext& context) {
    LaboratoryScene scene = command.scene.empty() ? scene_of_shot(command, context)
                                                  : pipeline::make_laboratory_scene(command.scene);
    if (!command.size.empty()) {
        set_size(scene, command.size);
    }
    return scene;
}

void run_sizes(const CompareCommand& command, const SizeList& list, CommandContext& context) {
    pipeline::ComparisonOptions options = options_of(command);
    if (options.shadow_rays.size() > 1) {
        throw InputError(fmt::format("--shadow-rays both cannot be used together with a {}",
                                     facts(list.size).words));
    }
    options.structures =
        checked([&] { return pipeline::structures_with_size(command.accelerators, list.size); });
    const LaboratoryScene scene = scene_of(command, context);
    const pipeline::SizeCurve curve = with_progress(context, [&](const auto& progress) {
        return pipeline::measure_sizes(scene, list.size, list.values, options, progress,
                                       context.stop);
    });
    write_result(command, curve, curve.comparisons.front().rows.empty());
}

void run_comparison(const CompareCommand& command, CommandContext& context) {
    if (const SizeList list = sizes_of(command); !list.values.empty()) {
        return run_sizes(command, list, context);
    }
    const pipeline::ComparisonOptions options = options_of(command);
    const LaboratoryScene scene = scene_of(command, context);
    const pipeline::Comparison comparison = with_progress(context, [&](const auto& progress) {
        return pipeline::compare_structures(scene, options, progress, context.stop);
    });
    write_result(command, comparison, comparison.rows.empty());
}

render::triangle::MeasureOptions kernel_options_of(const CompareCommand& command) {
    render::triangle::MeasureOptions options;
    options.rounds = command.rounds;
    options.kernels = checked([&] { return pipeline::kernels_from_text(command.triangles); });
    options.techniques =
        checked([&] { return pipeline::techniques_from_text(command.techniques); });
    if (command.compilers == "both") {
        options.libraries.push_back(render::triangle::other_kernels());
    }
    return options;
}

void run_triangles(const CompareCommand& command, CommandContext& context) {
    const render::triangle::MeasureOptions options = kernel_options_of(command);
    check_outputs(command);
    const auto measured = with_progress(context, [&](const auto& progress) {
        const WorkContext work{[&](double fraction) { progress("", fraction); }, context.stop};
        return render::triangle::measure_kernels(options, work);
    });
    write_result(command, measured, measured.errors.empty());
}

}  // namespace

void run(const CompareCommand& command, CommandContext& context) {
    if (!command.triangles.empty()) {
        return run_triangles(command, context);
    }
    check_what_is_compared(command);
    if (!command.growth.empty()) {
        run_growth(command, context);
    } else if (command.motion) {
        run_motion(command, context);
    } else {
        run_comparison(command, context);
    }
}

}  // namespace carom::cli
