// End-to-end tests of `carom compare`.
#include <csignal>
#include <set>
#include <sstream>
#include <thread>

#include <nlohmann/json.hpp>

#include "tests/pipeline/cli/end_to_end.h"

namespace carom::cli {
namespace {

using carom::testing::EndToEnd;
using carom::testing::RunningProgram;
using carom::testing::RunResult;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

class CompareCommand : public EndToEnd {};

std::vector<std::string> fields_of(const std::string& line) {
    std::vector<std::string> fields;
    std::istringstream rest(line + ",");
    for (std::string field; std::getline(rest, field, ',');) {
        fields.push_back(field);
    }
    return fields;
}

/// Checks that the names of all columns differ, and that every row has a field for each.
void expect_well_formed(const std::string& csv) {
    std::istringstream lines(csv);
    std::string line;
    ASSERT_TRUE(std::getline(lines, line));
    const std::vector<std::string> names = fields_of(line);
    EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size()) << line;
    while (std::getline(lines, line)) {
        EXPECT_EQ(fields_of(line).size(), names.size()) << line;
    }
}

TEST_F(CompareCommand, Scene_PrintsATable) {
    const RunResult result = run({"compare", "--scene", "sphere_cube", "--size", "16x16",
                                  "--accelerators", "brute_force,kdtree,embree", "--quiet"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.err, "");
    EXPECT_THAT(result.out, StartsWith("sphere_cube: 3375 spheres in a cube, 2 point lights\n"
                                       "16x16, 3375 shapes, "));
    for (const char* text :
         {"\nbrute_force  ", "\nkdtree  ", "\nembree  ", "build ms", "memory kB", "Mrays/s",
          "tests saved", "times as fast", "objects: all  primary  shadow"}) {
        EXPECT_THAT(result.out, HasSubstr(text));
    }
}

TEST_F(CompareCommand, FrameOfAShot_IsMeasuredByAllStructures) {
    const RunResult result = run({"compare", "tiny.yaml", "--frame", "2", "--size", "16x16",
                                  "--json", "--csv", "t.csv", "--plot", "t.svg", "-o", "t.json"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.out, "t.json\nt.csv\nt.svg\n");
    const auto json = nlohmann::json::parse(text_of("t.json"));
    EXPECT_EQ(json["scene"], "tiny");
    EXPECT_EQ(json["what"], "frame 2");
    EXPECT_EQ(json["whole"], 1);
    EXPECT_EQ(json["primary_rays"], 16 * 16 * 4);
    ASSERT_EQ(json["structures"].size(), 23u);
    const auto& brute = json["structures"][0];
    EXPECT_EQ(brute["structure"], "brute_force");
    EXPECT_EQ(brute["primary_objects"], json["shapes"].get<int>() * 16 * 16 * 4);
    EXPECT_FALSE(json["structures"][22].contains("primary_objects"));
    const std::string csv = text_of("t.csv");
    EXPECT_THAT(csv, StartsWith("scene,structure,shadow_query,build_seconds,bytes,cpu_seconds,"
                                "computed,counted,primary_rays,primary_objects,"));
    expect_well_formed(csv);
    EXPECT_EQ(brute["shadow_query"], "any");
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 24);
    EXPECT_THAT(csv, HasSubstr("\ntiny,embree,any,"));
    EXPECT_THAT(text_of("t.svg"), HasSubstr("wide_bvh"));
    EXPECT_EQ(stored_frames(), 0);  // comparing stores no pictures
}

TEST_F(CompareCommand, Growth_IsMeasuredInEveryForm) {
    const RunResult result =
        run({"compare", "--growth", "spheres", "--largest", "32", "--accelerators", "kdtree,embree",
             "--json", "--csv", "g.csv", "--plot", "g.svg", "-o", "g.json"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.out, "g.json\ng.csv\ng.svg\n");
    const auto json = nlohmann::json::parse(text_of("g.json"));
    EXPECT_EQ(json["growth"], "spheres");
    EXPECT_EQ(json["whole"], 1);
    ASSERT_EQ(json["points"].size(), 4u);
    EXPECT_EQ(json["points"][0]["structure"], "kdtree");
    EXPECT_EQ(json["points"][0]["shapes"], 10);
    EXPECT_GT(json["points"][2]["primary_boxes"], json["points"][0]["primary_boxes"]);
    EXPECT_FALSE(json["points"][3].contains("primary_boxes"));
    EXPECT_THAT(text_of("g.csv"),
                StartsWith("growth,structure,shapes,build_seconds,bytes,seconds_per_primary_ray,"));
    EXPECT_THAT(text_of("g.csv"), HasSubstr("\nspheres,embree,32,"));
    expect_well_formed(text_of("g.csv"));
    EXPECT_THAT(text_of("g.svg"), HasSubstr("<title>embree</title>"));
}

TEST_F(CompareCommand, Sizes_AreMeasuredInEveryForm) {
    const RunResult result =
        run({"compare", "--scene", "sphere_cube", "--size", "16x16", "--node-capacity", "8,2",
             "--json", "--csv", "s.csv", "--plot", "s.svg", "-o", "s.json"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.out, "s.json\ns.csv\ns.svg\n");
    const auto json = nlohmann::json::parse(text_of("s.json"));
    EXPECT_EQ(json["scene"], "sphere_cube");
    EXPECT_EQ(json["varied"], "node_capacity");
    ASSERT_EQ(json["points"].size(), 6u);
    EXPECT_EQ(json["points"][0]["node_capacity"], 2);
    EXPECT_EQ(json["points"][5]["structure"], "rtree_cyclic");
    EXPECT_THAT(text_of("s.csv"), StartsWith("scene,node_capacity,structure,shadow_query,"));
    EXPECT_THAT(text_of("s.csv"), HasSubstr("\nsphere_cube,8,rtree_hilbert,any,"));
    expect_well_formed(text_of("s.csv"));
    EXPECT_THAT(text_of("s.svg"), HasSubstr("<title>rtree</title>"));
    const RunResult grid =
        run({"compare", "tiny.yaml", "--size", "16x16", "--grid-density", "0.5,4", "--quiet"});
    EXPECT_EQ(grid.exit_code, 0) << grid.err;
    EXPECT_THAT(grid.out, HasSubstr("the first column: cells per shape\n"));
}

TEST_F(CompareCommand, Motion_IsMeasuredInEveryForm) {
    const RunResult result =
        run({"compare", "--motion", "20", "--intervals", "1,2", "--accelerators", "bvh,wide_bvh",
             "--json", "--csv", "m.csv", "--plot", "m.svg", "-o", "m.json"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    const auto json = nlohmann::json::parse(text_of("m.json"));
    EXPECT_EQ(json["balls"], 20);
    EXPECT_EQ(json["whole"], 1);
    ASSERT_EQ(json["points"].size(), 2u + 9 * 4);
    EXPECT_EQ(json["points"][3]["intervals"], 2);
    EXPECT_GT(json["points"][3]["primary_boxes"], 0);
    EXPECT_THAT(text_of("m.csv"), StartsWith("balls,structure,intervals,shutter,shapes,"));
    EXPECT_THAT(text_of("m.csv"), HasSubstr("\n20,wide_bvh,2,0.25,"));
    expect_well_formed(text_of("m.csv"));
    EXPECT_THAT(text_of("m.svg"), HasSubstr("<title>wide_bvh, 2 intervals</title>"));
}

TEST_F(CompareCommand, Lanes_AreColumnsOfGrowth) {
    const RunResult result = run({"compare", "--growth", "mesh", "--largest", "10", "--lanes", "4",
                                  "--accelerators", "hybrid", "--quiet"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.out, HasSubstr("ns per shadow ray of 64  hybrid, 4 lanes\n"));
}

TEST_F(CompareCommand, WrongUsage_IsRejectedWithASentence) {
    const auto message = [&](std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), "compare");
        const RunResult result = run(arguments);
        EXPECT_EQ(result.exit_code, 2);
        EXPECT_EQ(result.out, "");
        return result.err;
    };
    EXPECT_EQ(message({}),
              "carom: error: there is nothing to compare structures on: give a shot, --scene NAME, "
              "--growth NAME or --motion N\n");
    EXPECT_EQ(message({"--scene", "stadium", "--accelerators", "kdtree,quadtree"}),
              "carom: error: unknown structure 'quadtree'; use one of hybrid, embree, brute_force, "
              "single_boxes, grid, octree, octree_queue, octree_loose, octree_enclosing, "
              "octree_overlapping, octree_cut, kdtree, kdtree_median, bsp, rtree, rtree_hilbert, "
              "rtree_cyclic, kay_kajiya, box_volumes, sphere_volumes, oriented_box_volumes, bvh, "
              "wide_bvh, or all\n");
    EXPECT_EQ(message({"--scene", "stadium", "--frame", "3"}),
              "carom: error: --set, --quality and --frame can be used only with a shot\n");
    EXPECT_EQ(message({"--scene", "stadium", "--size", "8x8"}),
              "carom: error: --size '8x8' is not a size of 16 to 16384 pixels, as 160x120\n");
    EXPECT_EQ(message({"tiny.yaml", "--frame", "6"}),
              "carom: error: frame 6 is outside the film, which has the frames 0 to 5\n");
    EXPECT_EQ(message({"--scene", "stadium", "--plot", "x.pdf"}),
              "carom: error: 'x.pdf': a plot can only be written as .svg or .png\n");
    EXPECT_THAT(message({"--scene", "teapot"}), HasSubstr("--scene: teapot not in {sphere_cube,"));
    EXPECT_EQ(message({"tiny.yaml", "--scene", "stadium"}),
              "carom: error: SHOT|BAKE excludes --scene\n"
              "See 'carom compare --help'.\n");
    EXPECT_EQ(message({"--growth", "mesh", "--scene", "stadium"}),
              "carom: error: --scene excludes --growth\n"
              "See 'carom compare --help'.\n");
    EXPECT_EQ(
        message({"--scene", "stadium", "--leaf-capacity", "0,2"}),
        "carom: error: --leaf-capacity '0,2' is not a list of whole numbers from 1 to 1024\n");
    EXPECT_EQ(message({"--scene", "stadium", "--leaf-capacity", "2,"}),
              "carom: error: --leaf-capacity '2,' is not a list of whole numbers from 1 to 1024\n");
    EXPECT_EQ(
        message({"--scene", "stadium", "--node-capacity", "2.5"}),
        "carom: error: --node-capacity '2.5' is not a list of whole numbers from 2 to 1024\n");
    EXPECT_EQ(message({"--scene", "stadium", "--grid-density", "4,4"}),
              "carom: error: --grid-density names 4 twice\n");
    EXPECT_EQ(message({"--scene", "stadium", "--grid-density", "4", "--accelerators", "bvh"}),
              "carom: error: the structure 'bvh' does not depend on the grid density\n");
    EXPECT_EQ(message({"--scene", "stadium", "--leaf-capacity", "4", "--shadow-rays", "both"}),
              "carom: error: --shadow-rays both cannot be used together with a leaf capacity\n");
    EXPECT_THAT(message({"--scene", "stadium", "--leaf-capacity", "4", "--grid-density", "4"}),
                HasSubstr("excludes"));
    EXPECT_EQ(message({"--growth", "mesh", "--lanes", "6"}),
              "carom: error: --lanes '6' names others than 4, 8 and 16\n");
    EXPECT_THAT(message({"--scene", "stadium", "--lanes", "4"}), HasSubstr("requires --growth"));
    EXPECT_THAT(message({"--scene", "stadium", "--motion", "100"}), HasSubstr("excludes"));
    EXPECT_THAT(message({"--motion", "5"}), HasSubstr("--motion"));
    EXPECT_EQ(message({"--motion", "20", "--intervals", "0"}),
              "carom: error: --intervals '0' is not a list of whole numbers from 1 to 1000\n");
    EXPECT_EQ(message({"--scene", "stadium", "--largest", "100"}),
              "carom: error: --largest requires --growth\n"
              "See 'carom compare --help'.\n");
}

/// How far the program says that it is.
double last_fraction(const RunningProgram& program) {
    const std::string err = program.err_so_far();
    const std::size_t at = err.rfind("\"fraction\":");
    return at == std::string::npos ? 0.0 : std::atof(err.c_str() + at + 11);
}

TEST_F(CompareCommand, CtrlC_PrintsFinishedMeasurements) {
    // The first rows are finished immediately; brute force over walls takes longer.
    RunningProgram program(
        carom::testing::carom_program(),
        {"compare", "--scene", "cylinder_walls", "--size", "64x48", "--accelerators",
         "kdtree,brute_force", "--threads", "1", "--log", "json"},
        options());
    for (int i = 0; i < 10'000 && last_fraction(program) < 0.55; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    program.send(SIGINT);
    const RunResult result = program.wait();
    EXPECT_EQ(result.exit_code, 130);
    EXPECT_THAT(result.out, HasSubstr("\nkdtree  "));
    EXPECT_THAT(result.out,
                ::testing::EndsWith("\ninterrupted: the other structures are missing\n"));
    EXPECT_THAT(result.err,
                HasSubstr("interrupted; the results contain only what was measured by then"));
}

TEST_F(CompareCommand, Triangles_AreMeasuredInEveryForm) {
    const RunResult result =
        run({"compare", "--triangles", "wald,perpendicular_planes", "--rounds", "1", "--json",
             "--csv", "t.csv", "--plot", "t.png", "--width", "400", "-o", "t.json"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.out, "t.json\nt.csv\nt.png\n");
    const auto json = nlohmann::json::parse(text_of("t.json"));
    EXPECT_EQ(json["whole"], 1);
    EXPECT_EQ(json["rounds"], 1);
    ASSERT_EQ(json["kernels"].size(), 2u * 2 * 5 * 2);
    const auto& first = json["kernels"][0];
    EXPECT_EQ(first["kernel"], "wald");
    EXPECT_EQ(first["input"], "record");
    EXPECT_EQ(first["division"], "early");
    EXPECT_EQ(first["precision"], "float");
    EXPECT_EQ(first["packing"], "single");
    EXPECT_EQ(first["technique"], "plain");
    for (const char* number :
         {"random_rate", "worst_rate", "distance_error", "weight_error", "edge_slips"}) {
        EXPECT_GT(first[number], 0) << number;
    }
    ASSERT_EQ(json["planes_against_wald"].size(), 2u * 5 * 2);
    EXPECT_GT(json["planes_against_wald"][0]["random_ratio"], 0);
    const std::string csv = text_of("t.csv");
    EXPECT_THAT(csv,
                StartsWith("kernel,input,division,precision,packing,technique,compiler,random_rate,"
                           "worst_rate,streamed_rate,distance_error,weight_error,edge_slips,"
                           "other_hits\nwald,record,early,float,single,plain,"));
    expect_well_formed(csv);
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 40);
    EXPECT_THAT(text_of("t.png"), StartsWith("\x89PNG"));
}

TEST_F(CompareCommand, Triangles_PrintsTables) {
    const RunResult result = run({"compare", "--triangles", "keidy", "--rounds", "1", "--quiet"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.err, "");
    EXPECT_THAT(result.out, StartsWith("Millions of tests per second of CPU time, one round, "));
    for (const char* text :
         {"\nrandom rays, float ", "\nKeidy, corners, early ", "\nKeidy, with normal, deferred ",
          "\nevery ray hits, double ", "\nMean relative errors ", "\nBytes per triangle"}) {
        EXPECT_THAT(result.out, HasSubstr(text));
    }
    EXPECT_THAT(result.out, ::testing::Not(HasSubstr("relative to the plain variant")));
}

TEST_F(CompareCommand, Techniques_AreMeasuredAgainstThePlainVariant) {
    const RunResult result = run({"compare", "--triangles", "wald", "--techniques",
                                  "axis_fixed,newton", "--rounds", "1", "--quiet"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    for (const char* text :
         {"\nSpeed relative to the plain variant", "\nestimated reciprocal and a Newton step, ",
          "\nthe same axis for all triangles, ", "\nWald, record, early, axis_fixed  "}) {
        EXPECT_THAT(result.out, HasSubstr(text));
    }
}

TEST_F(CompareCommand, WrongUsageOfTriangles_IsRejectedWithASentence) {
    const auto message = [&](std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), "compare");
        const RunResult result = run(arguments);
        EXPECT_EQ(result.exit_code, 2);
        EXPECT_EQ(result.out, "");
        return result.err;
    };
    EXPECT_THAT(message({"--triangles", "woop"}), HasSubstr("unknown kernel 'woop'; use one of "));
    EXPECT_THAT(message({"--triangles", "all", "--scene", "stadium"}), HasSubstr("excludes"));
    EXPECT_THAT(message({"--triangles", "all", "tiny.yaml"}), HasSubstr("excludes"));
    EXPECT_THAT(message({"--triangles", "all", "--techniques", "axis"}),
                HasSubstr("unknown technique 'axis'; use one of arrays, structures, "));
    EXPECT_THAT(message({"--techniques", "newton"}), HasSubstr("requires"));
    EXPECT_THAT(message({"--rounds", "3"}), HasSubstr("requires"));
    EXPECT_THAT(message({"--triangles", "all", "--rounds", "0"}), HasSubstr("--rounds"));
}

TEST_F(CompareCommand, CtrlC_PrintsFinishedMeasurementsOfTriangles) {
    RunningProgram program(carom::testing::carom_program(),
                           {"compare", "--triangles", "wald", "--rounds", "1000", "--log", "json"},
                           options());
    for (int i = 0; i < 10'000 && last_fraction(program) <= 0; ++i) {  // something is measured
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    program.send(SIGINT);
    const RunResult result = program.wait();
    EXPECT_EQ(result.exit_code, 130);
    EXPECT_THAT(result.out, HasSubstr("\nWald, record, early "));
    EXPECT_THAT(result.out, ::testing::EndsWith("\ninterrupted: rounds or kernels are missing\n"));
}

// The shot has no meshes, so all structures give the same pixels.
TEST_F(CompareCommand, ShotWithAComparisonStructure_IsRenderedByTheLaboratory) {
    const auto picture = [&](const std::string& structure) {
        const RunResult result =
            run({"frame", "tiny.yaml", "--set", "render.acceleration=" + structure, "-o",
                 structure + ".png", "--quiet"});
        EXPECT_EQ(result.exit_code, 0) << result.err;
        EXPECT_EQ(result.err, "");
        return text_of(structure + ".png");
    };
    const std::string usual = picture("wide_bvh");
    EXPECT_EQ(picture("bvh"), usual);
    EXPECT_EQ(picture("kdtree"), usual);
    const RunResult film =
        run({"render", "tiny.yaml", "--set", "render.acceleration=grid", "-o", "film.mp4"});
    EXPECT_EQ(film.exit_code, 0) << film.err;
    EXPECT_TRUE(exists("film.mp4"));
}

TEST_F(CompareCommand, MissingLaboratory_IsAnErrorWhereItIsNeeded) {
    carom::testing::RunOptions without = options();
    without.environment["CAROM_LAB"] = path("no_laboratory");
    const auto message = [&](const std::vector<std::string>& arguments) {
        const RunResult result = carom::testing::run_carom(arguments, without);
        EXPECT_EQ(result.exit_code, 1);
        return result.err;
    };
    const std::string expected = "carom: error: cannot start the laboratory '" +
                                 path("no_laboratory") +
                                 "': No such file or directory; it is built by the target "
                                 "carom-lab and installed by the package carom-lab\n";
    EXPECT_EQ(message({"compare", "--scene", "stadium"}), expected);
    EXPECT_EQ(message({"render", "tiny.yaml", "--set", "render.acceleration=bvh"}), expected);
    EXPECT_EQ(stored_frames(), 0);
    EXPECT_EQ(carom::testing::run_carom({"frame", "tiny.yaml"}, without).exit_code, 0);
}

}  // namespace
}  // namespace carom::cli
