// The older text format of scenes, as the manual of its ray tracer describes it, made into a shot.
// docs/import.md says what becomes what.
#pragma once

#include <string>
#include <vector>

#include "pipeline/config/problem.h"

namespace carom::pipeline {

struct ImportOptions {
    double unit = 0.01;        // length of the author's unit, m, > 0
    bool is_z_up = false;      // else the author's y points up, and becomes our z
    double force_time = 0.05;  // s, for which a force acts; the text does not say
    double density = 1700;     // kg/m^3, of everything that moves; its motion does not depend on it
};

struct ImportResult {
    std::string yaml;                // empty if a problem is an error
    std::vector<Problem> problems;   // by place in the text
    std::vector<std::string> notes;  // what was approximated or assumed; in the YAML as comments
};

/// `name`: of the text, as problems print it. Pictures are looked for below `scene_folder`, where
/// the text is, and named relative to `shot_folder`, where the YAML will be. Nothing is written.
[[nodiscard]] ImportResult import_scene(const std::string& text, const std::string& name,
                                        const std::string& scene_folder,
                                        const std::string& shot_folder,
                                        const ImportOptions& options = {});

/// The same for a file. One that cannot be read is a problem.
[[nodiscard]] ImportResult import_scene_file(const std::string& path,
                                             const std::string& shot_folder,
                                             const ImportOptions& options = {});

}  // namespace carom::pipeline
