// Options of the command that measures the renderer itself.
#include "pipeline/cli/options/shared_options.h"

namespace carom::cli {

namespace {

void add_frame_choice(CommandDescription& description, CompareCommand& command) {
    Option& shot = description.argument("SHOT|BAKE", command.input.path,
                                        "A shot or a bake, one frame of which is measured.");
    shot.is_required = false;
    shot.offers(Offer::files, {"yaml", "yml", "bake"});
    description
        .option("--scene", &command.scene, "NAME",
                "Measure a scene of the laboratory instead of a shot: sphere_cube, cylinder_axes, "
                "cylinder_walls, full_view, stadium or smooth_mesh.")
        .excludes({"SHOT|BAKE"})
        .one_of({"sphere_cube", "cylinder_axes", "cylinder_walls", "full_view", "stadium",
                 "smooth_mesh"});
    description.option("--accelerators", &command.accelerators, "NAMES",
                       "Measure these structures: all (the default), or some, such as "
                       "brute_force,kdtree,rtree.");
    description
        .option("--shadow-rays", &command.shadow_rays, "NAME",
                "End shadow rays at any hit (the default), at the closest one as the oldest ray "
                "tracers did, or measure both.")
        .one_of({"any", "closest", "both"});
    description
        .option("--frame", &command.frame, "N",
                "The frame of the shot, counted from 0 (the default).")
        .from(0);
    description.option("--size", &command.size, "WxH",
                       "The size of the picture, such as 160x120. The default is its own.");
}

void add_output_files(CommandDescription& description, CompareCommand& command) {
    add_output(description, command.output, "Write to this file instead of standard output.");
    description.flag("--json", command.json, "Print one JSON object, with all digits.");
    description
        .option("--csv", &command.csv, "FILE",
                "Write a table as well, with a row for each structure or kernel.")
        .offers(Offer::files);
    description.option("--plot", &command.plot, "FILE", "Draw it as well, as .svg or .png.")
        .offers(Offer::files);
    add_drawing(description, command.drawing);
}

/// Measurements other than of one frame, which exclude what says something about a frame.
void add_other_measurements(CommandDescription& description, CompareCommand& command) {
    const std::vector<std::string> about_a_frame{"SHOT|BAKE", "--scene",  "--shadow-rays",
                                                 "--frame",   "--size",   "--set",
                                                 "--quality", "--threads"};
    description
        .option("--growth", &command.growth, "NAME",
                "Measure how the cost of a ray grows with the number of shapes: of spheres, of "
                "the triangles of a mesh, or of balls, half of which move.")
        .one_of({"spheres", "mesh", "balls"})
        .excludes(about_a_frame);
    description
        .option("--largest", &command.largest, "N",
                "The largest number of shapes for --growth (default 1000000).")
        .needs("--growth")
        .between(10, 10'000'000);
    std::vector<std::string> excluded = about_a_frame;
    excluded.insert(excluded.end(), {"--accelerators", "--growth"});
    description
        .option("--triangles", &command.triangles, "NAMES",
                "Measure ray-triangle kernels: all, or some, such as wald,badouel.")
        .excludes(excluded);
    description
        .option("--rounds", &command.rounds, "N",
                "How often each kernel is timed (default 5; 6 s per round for all of them).")
        .needs("--triangles")
        .between(1, 1000);
}

}  // namespace

void describe(CompareCommand& command, CommandDescription& description) {
    description.details = {
        "Every structure renders the same picture. They differ in the number of intersection tests "
        "per ray and in the time. Tests are counted in a frame of their own, so that counting "
        "takes no time from the frame that is timed. Brute force with more than 10^9 tests is "
        "computed instead of measured, and marked so.",
        "Triangle kernels are measured on one thread: with random rays and with rays that all hit, "
        "one, four and eight at a time, in float and double, with their errors.",
        "Ctrl-C ends the command with what is measured by then."};
    add_frame_choice(description, command);
    add_changes(description, command.input);
    add_output_files(description, command);
    add_threads(description, command.threads);
    add_other_measurements(description, command);
    add_cache(description, command.cache);
    description.examples = {
        {"carom compare --scene sphere_cube", "All structures on one scene."},
        {"carom compare break.yaml --frame 40 --accelerators kdtree,embree",
         "Two structures on a frame of a shot."},
        {"carom compare --scene cylinder_walls --shadow-rays both --plot walls.svg",
         "What shadow rays save that end at any hit."},
        {"carom compare --growth mesh --accelerators bvh,wide_bvh,embree",
         "How the cost grows with the size of a mesh."},
        {"carom compare --triangles all --csv kernels.csv", "All triangle kernels, as a table."}};
}

}  // namespace carom::cli
