// A finished picture: linear scene-referred RGBA and any number of further channels.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace carom::render {

/// One named plane of floats, row by row from the top left.
struct Channel {
    std::string name;  // EXR channel name: "Z", "N.X" ...
    std::vector<float> values;
    bool is_half = false;  // all values are half floats, and stored as such
};

/// Counters of the renderer.
struct RenderStatistics {
    std::uint64_t camera_rays = 0;
    std::uint64_t scattered_rays = 0;  // continued from a surface: reflection and transmission
    std::uint64_t shadow_rays = 0;
    // By the distributed integrator only, which counts kinds separately:
    std::uint64_t reflection_rays = 0;       // of the scattered rays
    std::uint64_t refraction_rays = 0;       // of the scattered rays
    std::uint64_t needless_shadow_rays = 0;  // counted as shadow rays, but known dark: not traced

    RenderStatistics& operator+=(const RenderStatistics& other) {
        camera_rays += other.camera_rays;
        scattered_rays += other.scattered_rays;
        shadow_rays += other.shadow_rays;
        reflection_rays += other.reflection_rays;
        refraction_rays += other.refraction_rays;
        needless_shadow_rays += other.needless_shadow_rays;
        return *this;
    }
};

struct Film {
    /// Header entries by key, as in an EXR file.
    using Notes = std::map<std::string, std::string>;

    int width = 0;  // pixels
    int height = 0;
    std::vector<float> rgba;  // width * height * 4, row by row from the top left; alpha is coverage
    std::vector<Channel> aovs;
    Notes notes;  // descriptions of the channels: Cryptomatte's manifests
    RenderStatistics statistics;
};

}  // namespace carom::render
