// Eleven small scenes, each for a part of the renderer that a picture can show to be wrong.
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

/// Prints the scene's name in GoogleTest's messages.
inline void PrintTo(const GoldenScene& scene, std::ostream* out) {
    *out << scene.name;
}

}  // namespace carom::test
