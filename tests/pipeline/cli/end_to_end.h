// A fixture that runs carom in a folder with a tiny shot and a separate cache.
#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/pipeline/cli/program_run.h"
#include "tests/pipeline/cli/tiny_shot.h"
#include "tests/scratch_folder.h"

namespace carom::testing {

class EndToEnd : public ::testing::Test {
  protected:
    EndToEnd() { write_text(folder_.path("tiny.yaml"), tiny_shot()); }

    [[nodiscard]] RunOptions options(const std::string& cache = "cache") const {
        return {folder_.path(), {{"CAROM_CACHE", folder_.path(cache)}}};
    }
    [[nodiscard]] RunResult run(const std::vector<std::string>& arguments) const {
        return run_carom(arguments, options());
    }
    [[nodiscard]] std::string path(const std::string& name) const { return folder_.path(name); }
    [[nodiscard]] std::string text_of(const std::string& name) const {
        return read_text(folder_.path(name));
    }
    [[nodiscard]] bool exists(const std::string& name) const {
        return std::filesystem::exists(folder_.path(name));
    }
    /// The names in the folder, sorted, except the shot and the caches.
    [[nodiscard]] std::vector<std::string> results() const {
        std::vector<std::string> names;
        for (const std::string& name : folder_.names()) {
            if (name != "tiny.yaml" && !name.starts_with("cache")) {
                names.push_back(name);
            }
        }
        std::sort(names.begin(), names.end());
        return names;
    }
    /// The number of finished frames in a cache.
    [[nodiscard]] int stored_frames(const std::string& cache = "cache") const {
        int count = 0;
        std::error_code ignored;
        for (std::filesystem::recursive_directory_iterator entry(path(cache), ignored), end;
             !ignored && entry != end; entry.increment(ignored)) {
            count += entry->path().extension() == ".exr" ? 1 : 0;
        }
        return count;
    }

  private:
    ScratchFolder folder_;
};

}  // namespace carom::testing
