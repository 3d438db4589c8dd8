// Ten and one small scenes, each for something that a picture can get wrong.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "render/frame/frame.h"
#include "sim/timeline/track.h"

namespace carom::test {

struct GoldenScene {
    std::string name;
    render::SceneDescription scene;
    render::RenderSettings settings;
    render::FrameInput frame;
    std::vector<sim::Track> tracks{};
};

[[nodiscard]] std::vector<GoldenScene> golden_scenes();

/// Its name, where GoogleTest shows a parameter.
inline void PrintTo(const GoldenScene& scene, std::ostream* out) {
    *out << scene.name;
}

}  // namespace carom::test
