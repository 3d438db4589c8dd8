// The options of the command that measures acceleration structures and triangle kernels.
#include "pipeline/cli/options/shared_options.h"

namespace carom::cli {

namespace {

void add_frame_choice(CommandDescription& description, CompareCommand& command) {
    Option& shot = description.argument("SHOT|BAKE", command.input.path,
                                        "A shot or a bake. One frame of it is measured.");
    shot.is_required = false;
    shot.offers(Offer::files, {"yaml", "yml", "bake"});
    description
        .option("--scene", &command.scene, "NAME",
                "Measure a scene of the laboratory instead of a shot: sphere_cube, cylinder_axes, "
                "cylinder_walls, full_view, partial_view, stadium or smooth_mesh.")
        .excludes({"SHOT|BAKE"})
        .one_of({"sphere_cube", "cylinder_axes", "cylinder_walls", "full_view", "partial_view",
                 "stadium", "smooth_mesh"});
    description.option("--accelerators", &command.accelerators, "NAMES",
                       "The structures to measure: all (the default), or a list such as "
                       "brute_force,kdtree,rtree.");
    description
        .option("--shadow-rays", &command.shadow_rays, "NAME",
                "End shadow rays at any hit (the default) or at the closest hit, as early ray "
                "tracers did, or measure both.")
        .one_of({"any", "closest", "both"});
    description
        .option("--frame", &command.frame, "N",
                "The frame of the shot, counted from 0 (the default).")
        .from(0);
    description.option("--size", &command.size, "WxH",
                       "The size of the picture, such as 160x120. The default is the size of the "
                       "shot or scene.");
}

void add_output_files(CommandDescription& description, CompareCommand& command) {
    add_output(description, command.output, "Write to this file instead of standard output.");
    description.flag("--json", command.json, "Print one JSON object, with all digits.");
    description
        .option("--csv", &command.csv, "FILE",
                "Also write a CSV table with a row for each structure or kernel.")
        .offers(Offer::files);
    description.option("--plot", &command.plot, "FILE", "Also draw the results, as .svg or .png.")
        .offers(Offer::files);
    add_drawing(description, command.drawing);
}

/// Adds the options about one frame that vary a structure.
void add_sizes(CommandDescription& description, CompareCommand& command) {
    description
        .option("--leaf-capacity", &command.leaf_capacity, "N,...",
                "Build the octrees, kd-trees, bsp and bvh so that N shapes are not divided any "
                "further, for each N of the list.")
        .excludes({"--node-capacity", "--grid-density"});
    description
        .option("--node-capacity", &command.node_capacity, "N,...",
                "Build the R-trees with N children per node, for each N of the list.")
        .excludes({"--grid-density"});
    description.option("--grid-density", &command.grid_density, "X,...",
                       "Build the grid with X cells per shape, for each X of the list.");
    description
        .option(
            "--kernel", &command.kernel, "NAMES",
            "Test the triangles of meshes with these kernels instead of the renderer's, each in "
            "turn: all, or a list such as wald,shevtsov. For structures that test triangles one "
            "by one, which are all except hybrid, wide_bvh and embree.")
        .excludes({"--leaf-capacity", "--node-capacity", "--grid-density"});
}

/// Adds the options for other measurements, which exclude the options about a frame.
void add_other_measurements(CommandDescription& description, CompareCommand& command) {
    const std::vector<std::string> about_a_frame{
        "SHOT|BAKE",       "--scene",         "--shadow-rays",  "--frame",
        "--size",          "--set",           "--quality",      "--threads",
        "--leaf-capacity", "--node-capacity", "--grid-density", "--kernel"};
    description
        .option("--growth", &command.growth, "NAME",
                "Measure how the cost of a ray grows with the number of shapes: spheres, the "
                "triangles of a mesh, or balls, half of which move.")
        .one_of({"spheres", "mesh", "balls"})
        .excludes(about_a_frame);
    description
        .option("--largest", &command.largest, "N",
                "The largest number of shapes for --growth (default 1000000).")
        .needs("--growth")
        .between(10, 10'000'000);
    description
        .option("--lanes", &command.lanes, "N,...",
                "Measure --growth with vectors of N numbers each, for each N of the list: 4 "
                "(SSE4), 8 (AVX2) or 16 (AVX-512). The default is what the processor has.")
        .needs("--growth");
    std::vector<std::string> not_in_motion = about_a_frame;
    not_in_motion.emplace_back("--growth");
    description
        .option("--motion", &command.motion, "N",
                "Measure N balls, half of which move, while the shutter is open for 0 to 1 s: one "
                "structure for the whole time against structures for parts of it.")
        .between(10, 1'000'000)
        .excludes(not_in_motion);
    description
        .option("--intervals", &command.intervals, "N,...",
                "Divide the shutter for --motion into N parts, for each N of the list (default "
                "1,4,16).")
        .needs("--motion");
    std::vector<std::string> excluded = about_a_frame;
    excluded.insert(excluded.end(), {"--accelerators", "--growth", "--motion"});
    description
        .option("--triangles", &command.triangles, "NAMES",
                "Measure ray-triangle kernels instead: all, or a list such as wald,badouel.")
        .excludes(excluded);
    description
        .option("--techniques", &command.techniques, "NAMES",
                "Also measure the kernels with these techniques: all, or a list such as "
                "arrays,structures (layouts in memory), newton (an estimated reciprocal with a "
                "Newton step), sign_bits (integer tests), axis_from_table, axis_by_versions, "
                "axis_by_order or axis_fixed (choices of the projection axis), any_hit (only "
                "whether a ray hits something), common_origin or parallel_rays (packets of rays "
                "that share one of the two).")
        .needs("--triangles");
    description
        .option("--compilers", &command.compilers, "NAME",
                "Measure the kernels as carom's compiler built them (own, the default), or both "
                "these and those of a second compiler (both), which are the target "
                "carom-other-kernels of the build.")
        .needs("--triangles")
        .one_of({"own", "both"});
    description
        .option(
            "--rounds", &command.rounds, "N",
            "How often each kernel is timed (default 5; a round of all kernels takes 10 s, with "
            "all techniques 35 s).")
        .needs("--triangles")
        .between(1, 1000);
}

}  // namespace

void describe(CompareCommand& command, CommandDescription& description) {
    description.details = {
        "All structures render the same picture, but differ in the number of intersection tests "
        "per ray and in the time. Tests are counted in a separate frame, so that counting does not "
        "slow down the frame that is timed. With more than 10^9 tests, the numbers of brute force "
        "are computed instead of measured, and marked as such.",
        "Triangle kernels are measured on one thread: with random rays and with rays that all hit, "
        "one, four and eight at a time, in float and double, with their errors.",
        "Ctrl-C ends the command and prints what was measured by then."};
    add_frame_choice(description, command);
    add_changes(description, command.input);
    add_output_files(description, command);
    add_threads(description, command.threads);
    add_sizes(description, command);
    add_other_measurements(description, command);
    add_cache(description, command.cache);
    description.examples = {
        {"carom compare --scene sphere_cube", "All structures on one scene."},
        {"carom compare break.yaml --frame 40 --accelerators kdtree,embree",
         "Two structures on a frame of a shot."},
        {"carom compare --scene cylinder_walls --shadow-rays both --plot walls.svg",
         "How much shadow rays save if they end at any hit."},
        {"carom compare --growth mesh --accelerators bvh,wide_bvh,embree",
         "How the cost grows with the size of a mesh."},
        {"carom compare --scene cylinder_axes --leaf-capacity 1,2,4,8 --plot leaves.svg",
         "How many shapes should share a leaf."},
        {"carom compare --growth balls --accelerators wide_bvh --lanes 4,8",
         "What wider vectors gain."},
        {"carom compare --motion 1000 --accelerators bvh,wide_bvh --plot motion.svg",
         "From which shutter on it pays to build several structures per frame."},
        {"carom compare --scene smooth_mesh --accelerators octree,bvh --kernel all",
         "Which triangle kernel is the fastest inside a structure."},
        {"carom compare --triangles all --csv kernels.csv", "All triangle kernels, as a table."},
        {"carom compare --triangles wald --techniques all",
         "All ways to choose the axis of Wald's."}};
}

}  // namespace carom::cli
