// Shots with one material.
#pragma once

#include <string>

#include "tests/folders.h"
#include "tests/pipeline/config/load.h"

namespace carom::pipeline {

/// A shot with an object whose material is "m".
inline std::string shot_of(const std::string& material) {
    return "carom: 1\n" + kCamera +
           "objects: {o: {sphere: 1, at: [5, 0, 1], material: m}}\n"
           "materials: {m: {" +
           material + "}}\n";
}

/// The name of a shot beside the folder `files`.
inline std::string in_test_folder() {
    return std::string(CAROM_SOURCE_DIR) + "/tests/pipeline/config/shot.yaml";
}

}  // namespace carom::pipeline
