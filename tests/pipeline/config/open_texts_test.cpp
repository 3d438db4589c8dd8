// Tests of texts that stand before the files of their names, and of the list of files.
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>

#include "tests/pipeline/config/load.h"
#include "tests/scratch_folder.h"

namespace carom::pipeline {
namespace {

namespace fs = std::filesystem;

/// A temporary folder for each test.
class OpenTexts : public ::testing::Test {
  protected:
    std::string path(const std::string& name) const { return (folder_ / name).string(); }
    std::string write(const std::string& name, const std::string& text) const {
        std::ofstream(path(name)) << text;
        return path(name);
    }
    std::vector<std::string> names(const LoadResult& result) const {
        std::vector<std::string> names;
        for (const ReadFile& file : result.files) {
            names.push_back(fs::path(file.path).lexically_relative(folder_).string());
        }
        return names;
    }

    carom::testing::ScratchFolder scratch_;
    fs::path folder_{fs::canonical(scratch_.path())};
    std::map<std::string, std::string> texts_;
};

TEST_F(OpenTexts, OpenText_IsReadInsteadOfItsFile) {
    const std::string shot = write("shot.yaml", "carom: 1\ninclude: part.yaml\n" + kCamera);
    write("part.yaml", "render: {samples: 1}\n");
    texts_[path("part.yaml")] = "render: {samples: 7}\n";
    EXPECT_EQ(load_shot(shot).shot->render.samples, 1);
    EXPECT_EQ(load_shot(shot, {.texts = &texts_}).shot->render.samples, 7);
    texts_[shot] = "carom: 1\n" + kCamera;
    EXPECT_EQ(load_shot(shot, {.texts = &texts_}).shot->render.samples, Shot{}.render.samples);
}

TEST_F(OpenTexts, OpenText_NeedsNoFile) {
    texts_[path("shot.yaml")] = "carom: 1\ninclude: part.yaml\n" + kCamera;
    texts_[path("part.yaml")] = "render: {samples: 7}\n";
    const LoadResult result = load_shot(path("shot.yaml"), {.texts = &texts_});
    EXPECT_EQ(all_problems(result), "");
    ASSERT_TRUE(result.shot);
    EXPECT_EQ(result.shot->render.samples, 7);
    EXPECT_THAT(names(result), ::testing::ElementsAre("shot.yaml", "part.yaml"));
}

TEST_F(OpenTexts, OpenTextOutsideTheRoot_IsNotRead) {
    texts_[path("part.yaml")] = "render: {samples: 7}\n";
    fs::create_directories(folder_ / "below");
    const std::string shot =
        write("below/shot.yaml", "carom: 1\ninclude: ../part.yaml\n" + kCamera);
    const LoadResult result = load_shot(shot, {.root = path("below"), .texts = &texts_});
    EXPECT_FALSE(result.shot);
    EXPECT_THAT(all_problems(result), ::testing::HasSubstr("is outside"));
}

TEST_F(OpenTexts, Files_AreListedAlsoWithErrors) {
    const std::string shot =
        write("shot.yaml", "carom: 1\ninclude: [part.yaml, none.yaml]\nnonsense: 1\n");
    write("part.yaml", "include: deep.yaml\nmore: nonsense\n");
    write("deep.yaml", "render: {samples: [\n");
    const LoadResult result = load_shot(shot);
    EXPECT_FALSE(result.shot);
    EXPECT_THAT(names(result), ::testing::ElementsAre("shot.yaml", "part.yaml", "deep.yaml"));
}

TEST_F(OpenTexts, Files_HaveTheNamesOfProblems) {
    const std::string shot = write("shot.yaml", "carom: 1\ninclude: part.yaml\n" + kCamera);
    write("part.yaml", "nonsense: 1\n");
    const LoadResult result = load_shot(shot);
    ASSERT_EQ(result.problems.size(), 1U);
    ASSERT_EQ(result.files.size(), 2U);
    EXPECT_EQ(result.problems.front().place.file, result.files[1].name);
}

}  // namespace
}  // namespace carom::pipeline
