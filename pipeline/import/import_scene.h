// Converts scenes in an older text format, which the manual of its ray tracer describes, to shots.
// docs/import.md lists the conversions.
#pragma once

#include <string>
#include <vector>

#include "pipeline/config/problem.h"

namespace carom::pipeline {

/// What the number FOV of the format means. Its manual contradicts itself.
enum class FieldOfView {
    distance,  // of a projection plane four units wide: the angle of view is 2 atan(2 / FOV)
    formula,   // the manual's formula: 2 atan(FOV / 2)
};

/// Which of the boxes that use physics move.
enum class BoxMotion {
    automatic,  // all except the ground and large ones
    fixed,
    dynamic,
};

struct ImportOptions {
    double unit = 0.01;        // length of the author's unit, m; > 0
    bool is_z_up = false;      // otherwise the author's y points up and becomes z
    double force_time = 0.05;  // duration of a force, s; the format has none
    FieldOfView field_of_view = FieldOfView::distance;
    BoxMotion boxes = BoxMotion::automatic;
    double density = 1700;  // kg/m^3, of all moving bodies; the motion does not depend on it
};

struct ImportResult {
    std::string yaml;                // empty if a problem is an error
    std::vector<Problem> problems;   // by place in the text
    std::vector<std::string> notes;  // approximations and assumptions, also comments in the YAML
};

/// `name`: the name of the text in problems. Images are searched below `scene_folder`, the folder
/// of the text, and their paths are relative to `shot_folder`, the folder of the YAML. No file is
/// written.
[[nodiscard]] ImportResult import_scene(const std::string& text, const std::string& name,
                                        const std::string& scene_folder,
                                        const std::string& shot_folder,
                                        const ImportOptions& options = {});

/// The same for a file. A file that cannot be read is reported as a problem.
[[nodiscard]] ImportResult import_scene_file(const std::string& path,
                                             const std::string& shot_folder,
                                             const ImportOptions& options = {});

}  // namespace carom::pipeline
