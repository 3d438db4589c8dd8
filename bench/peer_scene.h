// The scene for comparisons between renderers, from its neutral JSON description.
#pragma once

#include <string>
#include <vector>

#include "render/frame/frame.h"

namespace carom::bench {

struct PeerScene {
    render::SceneDescription scene;
    std::vector<sim::Track> tracks;  // of the balls
    render::FrameInput frame;
    render::RenderSettings settings;  // size and filter; full transport with four bounces
};

/// Reads "neutral billiard scene 1": boxes, balls in uniform motion during the shutter, a rectangle
/// light and a sphere light, a constant environment, a thin lens. Throws std::exception.
[[nodiscard]] PeerScene read_peer_scene(const std::string& path);

}  // namespace carom::bench
