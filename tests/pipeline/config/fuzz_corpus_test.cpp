// Loads the seeds and the findings of the fuzzer: each file is a valid shot or has errors.
#include <filesystem>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "pipeline/config/load_shot.h"
#include "tests/folders.h"

namespace carom::pipeline {
namespace {

TEST(FuzzCorpus, EveryFile_IsAShotThatLoadsAgainOrHasErrors) {
    int files = 0;
    for (const auto& entry :
         std::filesystem::directory_iterator(CAROM_SOURCE_DIR "/tests/fuzz/corpus/yaml")) {
        ++files;
        std::ifstream file(entry.path());
        std::stringstream text;
        text << file.rdbuf();
        const LoadResult result = load_shot_text(text.str(), "/nowhere/fuzz.yaml");
        EXPECT_NE(result.shot.has_value(), has_errors(result.problems)) << entry.path();
        if (result.shot) {
            EXPECT_TRUE(load_shot_text(result.shot->resolved_text, "/nowhere/again.yaml").shot)
                << entry.path();
        }
    }
    EXPECT_GE(files, 6);
}

}  // namespace
}  // namespace carom::pipeline
