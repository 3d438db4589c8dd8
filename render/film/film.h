// A finished picture: linear scene-referred RGBA and any number of further channels.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace carom::render {

/// One named plane of floats, row by row from the top left.
struct Channel {
    std::string name;  // EXR channel name: "Z", "N.X" ...
    std::vector<float> values;
};

/// One of half floats, as their bits.
struct HalfChannel {
    std::string name;
    std::vector<std::uint16_t> bits;
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
    /// Samples that were negative or not finite, which a formula of the renderer is to blame for.
    /// They count as black.
    std::uint64_t unusable_samples = 0;
    std::array<int, 2> unusable_pixel{-1, -1};  // x and y of the first pixel that has some

    RenderStatistics& operator+=(const RenderStatistics& other) {
        camera_rays += other.camera_rays;
        scattered_rays += other.scattered_rays;
        shadow_rays += other.shadow_rays;
        reflection_rays += other.reflection_rays;
        refraction_rays += other.refraction_rays;
        needless_shadow_rays += other.needless_shadow_rays;
        if (other.unusable_samples > 0) {
            add_unusable(other.unusable_samples, other.unusable_pixel);
        }
        return *this;
    }
    void add_unusable(std::uint64_t samples, const std::array<int, 2>& pixel) {
        const auto row_by_row = [](const std::array<int, 2>& at) {
            return std::pair(at[1], at[0]);
        };
        if (unusable_samples == 0 || row_by_row(pixel) < row_by_row(unusable_pixel)) {
            unusable_pixel = pixel;
        }
        unusable_samples += samples;
    }
};

struct Film {
    /// Header entries by key, as in an EXR file.
    using Notes = std::map<std::string, std::string>;

    int width = 0;  // pixels
    int height = 0;
    std::vector<float> rgba;  // width * height * 4, row by row from the top left; alpha is coverage
    std::vector<Channel> aovs;
    std::vector<HalfChannel> half_aovs;  // for the denoiser; only packed films have them
    Notes notes;                         // descriptions of the channels: Cryptomatte's manifests
    RenderStatistics statistics;
};

}  // namespace carom::render
