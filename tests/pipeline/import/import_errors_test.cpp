// Error messages for wrong scene texts.
#include <filesystem>
#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

#include "pipeline/config/load_shot.h"
#include "pipeline/import/import_scene.h"
#include "tests/folders.h"

namespace carom::pipeline {
namespace {

std::string errors_of(const std::string& text) {
    std::string all;
    const ImportResult result = import_scene(text, "scene.txt", "/nowhere", "/nowhere");
    for (const Problem& problem : result.problems) {
        all += format(problem);
    }
    EXPECT_EQ(result.yaml.empty(), has_errors(result.problems)) << all;
    return all;
}

const std::string kCamera =
    "camera C { video_end 1 add_position { 0 0 0 } add_target { 0 0 9 } }\n";

TEST(ImportErrors, SeveralMistakes_AreAllReportedWithTheirPositions) {
    EXPECT_EQ(
        errors_of(kCamera + "phong_info P { diffuse { 1 0 } shinyness 4 }\n"
                            "material_phong M { phong_info Q }\n"
                            "sphere S { position { 0 zero 0 } radius -2 material M }\n"
                            "spher T { }\n"),
        "scene.txt:2:24: error: 'diffuse' of phong_info 'P' must be three numbers in braces, "
        "not 2\n"
        "    2 | phong_info P { diffuse { 1 0 } shinyness 4 }\n"
        "      |                        ^\n"
        "scene.txt:2:32: error: unknown attribute 'shinyness' in phong_info 'P' (did you mean "
        "'shininess'?)\n"
        "    2 | phong_info P { diffuse { 1 0 } shinyness 4 }\n"
        "      |                                ^~~~~~~~~\n"
        "scene.txt:3:31: error: phong_info 'Q' is not defined above this line\n"
        "    3 | material_phong M { phong_info Q }\n"
        "      |                               ^\n"
        "scene.txt:4:25: error: 'position' of sphere 'S' must be three numbers in braces, not "
        "'zero'\n"
        "    4 | sphere S { position { 0 zero 0 } radius -2 material M }\n"
        "      |                         ^~~~\n"
        "scene.txt:4:41: error: 'radius' of sphere 'S' must be a number above 0, not '-2'\n"
        "    4 | sphere S { position { 0 zero 0 } radius -2 material M }\n"
        "      |                                         ^~\n"
        "scene.txt:5:1: error: unknown element 'spher' (did you mean 'sphere'?)\n"
        "    5 | spher T { }\n"
        "      | ^~~~~\n");
}

TEST(ImportErrors, UnmatchedBraces_AreReported) {
    EXPECT_EQ(errors_of("settings S { width 64\n"),
              "scene.txt:1:12: error: '{' has no matching '}'\n"
              "    1 | settings S { width 64\n"
              "      |            ^\n");
    EXPECT_EQ(errors_of(kCamera + "}"),
              "scene.txt:2:1: error: '}' has no matching '{'\n"
              "    2 | }\n"
              "      | ^\n");
}

TEST(ImportErrors, DuplicateNamesAndAttributes_AreErrors) {
    EXPECT_EQ(errors_of(kCamera + kCamera + "texture T { filename a filename b }"),
              "scene.txt:2:8: error: camera 'C' is already defined in line 1\n"
              "    2 | " +
                  kCamera +
                  "      |        ^\n"
                  "scene.txt:3:24: error: 'filename' is given twice in texture 'T'\n"
                  "    3 | texture T { filename a filename b }\n"
                  "      |                        ^~~~~~~~\n");
}

TEST(ImportErrors, MissingMandatoryParts_AreNamed) {
    EXPECT_EQ(errors_of("camera C { }"),
              "scene.txt:1:8: error: camera 'C' needs 'add_position'\n"
              "    1 | camera C { }\n"
              "      |        ^\n"
              "scene.txt:1:8: error: camera 'C' needs 'add_target'\n"
              "    1 | camera C { }\n"
              "      |        ^\n");
    EXPECT_EQ(errors_of(""), "scene.txt:1:1: error: the scene has no camera\n");
}

TEST(ImportErrors, OverlappingCameras_AreAnError) {
    EXPECT_EQ(errors_of(kCamera + "camera D { video_start 0.5 video_end 2 add_position { 0 0 0 } "
                                  "add_target { 0 0 9 } }"),
              "scene.txt:2:8: error: camera 'D' starts before camera 'C' ends\n"
              "    2 | camera D { video_start 0.5 video_end 2 add_position { 0 0 0 } add_target { "
              "0 0 9 } }\n"
              "      |        ^\n");
}

TEST(ImportErrors, MissingFile_IsAProblem) {
    const ImportResult result = import_scene_file("/nowhere/scene.txt", ".");
    ASSERT_EQ(result.problems.size(), 1U);
    EXPECT_EQ(result.problems[0].message, "this file does not exist");
    EXPECT_TRUE(result.yaml.empty());
}

// The fuzzer's corpus with its seeds and findings: each file is either refused or converted to
// YAML.
TEST(ImportErrors, EveryFileOfTheCorpus_IsRefusedOrConverted) {
    int files = 0;
    for (const auto& entry :
         std::filesystem::directory_iterator(CAROM_SOURCE_DIR "/tests/fuzz/corpus/scene")) {
        ++files;
        std::ifstream file(entry.path());
        const std::string text{std::istreambuf_iterator<char>(file), {}};
        const ImportResult result = import_scene(text, "fuzz.txt", "/nowhere", "/nowhere");
        EXPECT_NE(result.yaml.empty(), !has_errors(result.problems)) << entry.path();
    }
    EXPECT_GE(files, 3);
}

}  // namespace
}  // namespace carom::pipeline
