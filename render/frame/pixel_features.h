// What the camera sees of a pixel, for the denoiser.
#pragma once

#include <array>
#include <cstddef>

#include "render/integrator/integrator.h"

namespace carom::render {

/// Sums or means over a pixel of what its camera rays see at their first hits and, if these have a
/// coat, of what is seen in it.
struct PixelFeatures {
    static constexpr std::size_t kCount = 9;
    static constexpr std::size_t kNormal = 3;  // index of the first one
    static constexpr std::size_t kLight = 6;
    static constexpr std::size_t kPadded = 12;  // whole vectors of four; the last ones are 0

    /// Albedo (with the mirrored albedo, as the coat reflects it); normal; radiance of lights and
    /// the room, seen directly or in a smooth coat.
    alignas(16) std::array<float, kPadded> values{};

    [[nodiscard]] static PixelFeatures of(const RadianceSample& sample) {
        const V3f albedo = sample.albedo + sample.mirrored;
        const V3f& normal = sample.normal;
        const V3f& light = sample.light;
        return {{albedo.x, albedo.y, albedo.z, normal.x, normal.y, normal.z, light.x, light.y,
                 light.z, 0, 0, 0}};
    }
    bool operator==(const PixelFeatures&) const = default;
    [[nodiscard]] float operator[](std::size_t i) const { return values[i]; }
    PixelFeatures& operator+=(const PixelFeatures& other) {
        for (std::size_t i = 0; i < kPadded; ++i) {
            values[i] += other.values[i];
        }
        return *this;
    }
    [[nodiscard]] PixelFeatures operator*(float factor) const {
        PixelFeatures result;
        for (std::size_t i = 0; i < kPadded; ++i) {
            result.values[i] = values[i] * factor;
        }
        return result;
    }
};

}  // namespace carom::render
