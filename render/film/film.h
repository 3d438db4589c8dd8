// A finished picture: linear scene-referred RGBA and any number of further channels.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace carom::render {

/// One named plane of floats, row by row from the top left.
struct Channel {
    std::string name;  // EXR channel name: "Z", "N.X" ...
    std::vector<float> values;
};

/// What the renderer counted.
struct RenderStatistics {
    std::uint64_t camera_rays = 0;
    std::uint64_t scattered_rays = 0;
    std::uint64_t shadow_rays = 0;
};

struct Film {
    int width = 0;  // pixels
    int height = 0;
    std::vector<float> rgba;  // width * height * 4, row by row from the top left; alpha is coverage
    std::vector<Channel> aovs;
    RenderStatistics statistics;
};

}  // namespace carom::render
