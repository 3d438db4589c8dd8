// What measures the renderer itself.
#include "pipeline/cli/options/command_options.h"
#include "pipeline/cli/options/shared_options.h"

namespace carom::cli {

namespace {

void add_compared(CLI::App& command, CompareCommand& compare) {
    CLI::Option* shot =
        command.add_option("SHOT|BAKE", compare.input.path, "a shot or a bake, one frame of it")
            ->option_text(" ");
    command
        .add_option("--scene", compare.scene,
                    "or a scene of the laboratory: sphere_cube, cylinder_axes, cylinder_walls, "
                    "full_view, stadium, smooth_mesh")
        ->option_text("NAME")
        ->excludes(shot)
        ->check(CLI::IsMember({"sphere_cube", "cylinder_axes", "cylinder_walls", "full_view",
                               "stadium", "smooth_mesh"}));
    command
        .add_option("--accelerators", compare.accelerators,
                    "which structures: all (the default), or some: brute_force,kdtree,rtree")
        ->option_text("NAMES");
    command
        .add_option("--shadow-rays", compare.shadow_rays,
                    "end at any hit (the default), at the closest one as the oldest ray tracers "
                    "had it, or both to see what that saves")
        ->option_text("NAME")
        ->check(CLI::IsMember({"any", "closest", "both"}));
    command.add_option("--frame", compare.frame, "of the shot, counted from 0 (the default)")
        ->option_text("N")
        ->check(CLI::NonNegativeNumber);
    command.add_option("--size", compare.size, "of the picture, 160x120 (else its own)")
        ->option_text("WxH");
}

/// Many scenes instead of one frame.
void add_growth(CLI::App& command, CompareCommand& compare) {
    CLI::Option* growth =
        command
            .add_option("--growth", compare.growth,
                        "or how the cost of a ray grows with the number of shapes: of spheres, or "
                        "of a mesh's triangles")
            ->option_text("NAME")
            ->check(CLI::IsMember({"spheres", "mesh"}));
    for (const char* name : {"SHOT|BAKE", "--scene", "--shadow-rays", "--frame", "--size", "--set",
                             "--quality", "--threads"}) {
        growth->excludes(command.get_option(name));
    }
    command.add_option("--largest", compare.largest, "how many of them (default 1000000)")
        ->option_text("N")
        ->needs(growth)
        ->check(CLI::Range(10, 10'000'000));
}

/// Nothing of what is said about a frame goes with it.
void add_triangles(CLI::App& command, CompareCommand& compare) {
    CLI::Option* triangles =
        command
            .add_option("--triangles", compare.triangles,
                        "measure ray-triangle kernels instead: all, or some: wald,badouel")
            ->option_text("NAMES");
    for (const char* name : {"SHOT|BAKE", "--scene", "--accelerators", "--shadow-rays", "--frame",
                             "--size", "--set", "--quality", "--threads", "--growth"}) {
        triangles->excludes(command.get_option(name));
    }
    command
        .add_option("--rounds", compare.rounds,
                    "how often each kernel is timed, in turn (default 5, 6 s each for all)")
        ->option_text("N")
        ->needs(triangles)
        ->check(CLI::Range(1, 1000));
}

}  // namespace

void add_compare(CLI::App& app, Targets& targets) {
    CLI::App& command = *app.add_subcommand("compare", "measure structures or triangle kernels");
    CompareCommand& compare = targets.compare;
    add_compared(command, compare);
    add_changes(command, compare.input);
    add_output(command, compare.output, "else standard output");
    command.add_flag("--json", compare.json, "one JSON object, with all digits");
    command.add_option("--csv", compare.csv, "a table as well, a structure or kernel to a row")
        ->option_text("FILE");
    command.add_option("--plot", compare.plot, "a drawing of it as well: .svg or .png")
        ->option_text("FILE");
    add_drawing(command, compare.drawing);
    add_threads(command, compare.threads);
    add_growth(command, compare);
    add_triangles(command, compare);
    add_cache(command, compare.cache);
    add_talk(command, targets);
    command.footer(
        example("  carom compare --scene sphere_cube\n"
                "  carom compare break.yaml --frame 40 --accelerators kdtree,embree\n"
                "  carom compare --scene cylinder_walls --shadow-rays both --plot walls.svg\n"
                "  carom compare --growth mesh --accelerators bvh,wide_bvh,embree\n"
                "  carom compare --triangles all --csv kernels.csv\n") +
        "\nEvery structure renders the same picture; what differs is the number of tests\n"
        "for a ray, and the time. Tests are counted in a frame of their own: counting\n"
        "takes no time from the one that is timed. Brute force of more than 10^9 tests\n"
        "is computed, which is said. Triangle kernels are measured on one thread: on\n"
        "random rays and on rays that all hit, one at a time, four and eight, in float\n"
        "and double, with their errors. Ctrl-C ends with what is measured by then.");
}

}  // namespace carom::cli
