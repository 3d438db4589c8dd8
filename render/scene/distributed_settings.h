// How the classic distributed ray tracer works: how many rays each effect gets.
#pragma once

namespace carom::render {

/// A count of 1 switches its effect off: the pixel's centre, the middle of the exposure, the centre
/// of the lens or of the light, the exact mirrored or refracted direction. With all counts at 1 it
/// is the tracer of Whitted 1980. Each count lies in [1, 1024].
struct DistributedSettings {
    /// A pixel gets the product of these three, at most 65536, as one set of well-spread points.
    int pixel_samples = 4;
    int blur_samples = 4;
    int lens_samples = 4;
    int shadow_samples = 4;      // per light and point
    int reflection_samples = 4;  // per point; 1 where nothing spreads them
    int refraction_samples = 4;  // per point; 1 where nothing spreads them
    int recursion_limit = 3;     // generations of rays after the camera's, [0, 32]
    /// Whether shadow, reflection and refraction samples halve with each generation, down to 1.
    bool falloff = true;
    double ambient_coefficient = 0.12;  // radiance of the ambient light, W/(m^2 sr)

    bool operator==(const DistributedSettings&) const = default;
};

/// How many of `count` samples are taken so many generations after the camera's rays.
[[nodiscard]] constexpr int samples_at(int count, int generation, bool falloff) {
    if (!falloff || generation >= 31) {
        return falloff ? 1 : count;
    }
    const int divisor = 1 << generation;
    return count / divisor + (count % divisor != 0 ? 1 : 0);
}

/// Camera rays per pixel.
[[nodiscard]] constexpr int camera_samples(const DistributedSettings& settings) {
    return settings.pixel_samples * settings.blur_samples * settings.lens_samples;
}

}  // namespace carom::render
