// Helpers that load a shot from a text.
#pragma once

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "pipeline/config/load_shot.h"
#include "tests/folders.h"

namespace carom::pipeline {

/// A camera, so that a shot has no warning about missing cameras.
inline const std::string kCamera =
    "cameras: [{video: [0 s, 1 s], scene: [0 s, 1 s], position: [0, -2, 1], target: [0, 0, 0]}]\n";

inline std::string all_problems(const LoadResult& result) {
    std::string text;
    for (const Problem& problem : result.problems) {
        text += format(problem);
    }
    return text;
}

/// The shot of a text without problems; paths are relative to tests/pipeline/config.
inline Shot load(const std::string& text, const std::vector<std::string>& overrides = {},
                 const std::string& quality = {}) {
    const std::string origin = std::string(CAROM_SOURCE_DIR) + "/tests/pipeline/config/shot.yaml";
    LoadResult result = load_shot_text(text, origin, {.overrides = overrides, .quality = quality});
    EXPECT_EQ(all_problems(result), "");
    return result.shot ? std::move(*result.shot) : Shot{};
}

/// Like load, for the given sections and a camera.
inline Shot load_sections(const std::string& sections) {
    const bool has_camera = sections.find("cameras:") != std::string::npos;
    return load("carom: 1\n" + (has_camera ? std::string() : kCamera) + sections);
}

/// The first problem of a text.
inline std::string first_problem(const std::string& text) {
    const LoadResult result = load_shot_text(text, "t.yaml");
    return result.problems.empty() ? "" : result.problems[0].message;
}

}  // namespace carom::pipeline
