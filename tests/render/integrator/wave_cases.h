// The scenes with which waves are tested.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "render/integrator/path_integrator.h"
#include "tests/render/integrator/integrator_scene.h"

namespace carom::test {

constexpr double kWaveShutter = 0.02;  // s

struct WaveCase {
    std::string name;
    std::function<void(SceneBuilder&)> furnish;
    render::PathSettings path{};
};

/// Each adds to the table.
[[nodiscard]] std::vector<WaveCase> wave_cases();

/// A table with balls at rest and moving, one of them deflected by an impact.
void add_table(SceneBuilder& builder);
[[nodiscard]] std::vector<sim::Track> table_tracks();
void add_lights(SceneBuilder& builder);
/// Balls on cloth with sheen, and shapes with a picture: vectors contain paths of several.
void add_mixed_materials(SceneBuilder& builder);

}  // namespace carom::test
