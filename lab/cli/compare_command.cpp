#include <fmt/core.h>

#include "lab/cli/compare_output.h"
#include "lab/cli/compare_triangles.h"
#include "lab/cli/comparison_data.h"
#include "lab/comparison/comparison.h"
#include "lab/comparison/comparison_plot.h"
#include "lab/comparison/comparison_text.h"
#include "lab/comparison/growth.h"
#include "lab/comparison/growth_text.h"
#include "lab/comparison/kernel_names.h"
#include "lab/comparison/lane_limit.h"
#include "lab/comparison/motion.h"
#include "lab/comparison/motion_text.h"
#include "lab/comparison/size_curve.h"
#include "lab/comparison/size_text.h"
#include "pipeline/cli/bake_input.h"
#include "pipeline/cli/drawing_output.h"
#include "pipeline/cli/film_input.h"
#include "pipeline/cli/run_program.h"
#include "pipeline/cli/shot_input.h"
#include "pipeline/job/film_plan.h"

namespace carom::cli {

namespace {

using pipeline::Comparison;
using pipeline::GrowingScene;
using pipeline::LaboratoryScene;
using pipeline::ShadowRays;
using render::VariedSize;

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

/// The result of `work`; its Error is one of the user's input.
template <class Work>
auto checked(const Work& work) {
    try {
        return work();
    } catch (const Error& error) {
        throw InputError(error.what());
    }
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
    if (!command.leaf_capacity.empty()) {
        return {VariedSize::leaf_capacity,
                numbers_of(command.leaf_capacity, {"--leaf-capacity", 1, 1024})};
    }
    if (!command.node_capacity.empty()) {
        return {VariedSize::node_capacity,
                numbers_of(command.node_capacity, {"--node-capacity", 2, 1024})};
    }
    if (!command.grid_density.empty()) {
        return {VariedSize::grid_density,
                numbers_of(command.grid_density, {"--grid-density", 0.001, 1000, false})};
    }
    return {};
}

std::vector<int> lanes_of(const CompareCommand& command) {
    std::vector<int> lanes;
    if (command.lanes.empty()) {
        return lanes;
    }
    for (const double number : numbers_of(command.lanes, {"--lanes", 4, 16})) {
        lanes.push_back(static_cast<int>(number));
        if (lanes.back() != 4 && lanes.back() != 8 && lanes.back() != 16) {
            throw InputError("--lanes '" + command.lanes + "' names others than 4, 8 and 16");
        }
        if (!pipeline::LaneLimit::machine_has(lanes.back())) {
            throw InputError(
                fmt::format("this processor has no vectors of {} numbers", lanes.back()));
        }
    }
    return lanes;
}

void run_growth(const CompareCommand& command, CommandContext& context) {
    pipeline::GrowthOptions options;
    options.structures = options_of(command).structures;
    options.largest = static_cast<std::size_t>(command.largest);
    options.lanes = lanes_of(command);
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

void run_motion(const CompareCommand& command, CommandContext& context) {
    pipeline::MotionOptions options;
    options.structures = options_of(command).structures;
    options.balls = static_cast<std::size_t>(*command.motion);
    if (!command.intervals.empty()) {
        options.intervals.clear();
        for (const double number : numbers_of(command.intervals, {"--intervals", 1, 1000})) {
            options.intervals.push_back(static_cast<int>(number));
        }
    }
    const pipeline::Motion motion = with_progress(context, [&](const auto& progress) {
        return pipeline::measure_motion(options, progress, context.stop);
    });
    if (!motion.points.empty()) {
        const auto page = page_of(command.drawing.page, command.plot);
        write_texts(command, {command.json ? motion_json(motion) : pipeline::motion_text(motion),
                              motion_csv(motion), pipeline::motion_plot_svg(motion, page)});
    }
    stop_unless(motion.is_whole);
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
                                     pipeline::words_of(list.size)));
    }
    options.structures =
        checked([&] { return pipeline::structures_with_size(command.accelerators, list.size); });
    const LaboratoryScene scene = scene_of(command, context);
    const pipeline::SizeCurve curve = with_progress(context, [&](const auto& progress) {
        return pipeline::measure_sizes(scene, list.size, list.values, options, progress,
                                       context.stop);
    });
    if (!curve.comparisons.front().rows.empty()) {
        const auto page = page_of(command.drawing.page, command.plot);
        write_texts(command, {command.json ? sizes_json(curve) : pipeline::size_text(curve),
                              sizes_csv(curve), pipeline::size_plot_svg(curve, page)});
    }
    stop_unless(curve.is_whole);
}

void run_comparison(const CompareCommand& command, CommandContext& context) {
    if (const SizeList list = sizes_of(command); !list.values.empty()) {
        return run_sizes(command, list, context);
    }
    const pipeline::ComparisonOptions options = options_of(command);
    const LaboratoryScene scene = scene_of(command, context);
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
    } else if (command.motion) {
        run_motion(command, context);
    } else {
        run_comparison(command, context);
    }
}

}  // namespace carom::cli
