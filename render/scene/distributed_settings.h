// Settings of the distributed integrator: the number of rays for each effect.
#pragma once

#include <cstddef>

namespace carom::render {

/// A count of 1 switches its effect off: it uses the pixel's centre, the middle of the exposure,
/// the centre of the lens or of the light, or the exact reflected or refracted direction. With all
/// counts at 1 it is the ray tracer of Whitted 1980. Each count lies in [1, 1024]; those of
/// reflection and refraction may be 0, which sends no such rays at all.
struct DistributedSettings {
    /// A pixel takes the product of these three, at most 65536, as one set of well-spread points.
    int pixel_samples = 4;
    int blur_samples = 4;
    int lens_samples = 4;
    int shadow_samples = 4;      // per light and point
    int reflection_samples = 4;  // per point; 1 for reflection without a spread
    int refraction_samples = 4;  // per point; 1 for refraction without a spread
    int recursion_limit = 3;     // generations of rays after the camera's, [0, 32]
    /// Whether shadow, reflection and refraction samples halve with each generation, down to 1.
    bool falloff = true;
    double ambient_coefficient = 0.12;  // radiance of the ambient light, W/(m^2 sr)

    bool operator==(const DistributedSettings&) const = default;
};

/// The number of samples `generation` generations after the camera's rays.
[[nodiscard]] constexpr int samples_at(int count, int generation, bool falloff) {
    if (!falloff || count == 0) {
        return count;
    }
    if (generation >= 31) {
        return 1;
    }
    const int divisor = 1 << generation;
    return count / divisor + (count % divisor != 0 ? 1 : 0);
}

/// The number of rays for one camera ray if every surface reflects and refracts, both with a
/// spread, and every ray hits a surface: the sum over generations n = 0 ... r of the rays of that
/// generation times (1 + lights x shadow samples). Without falloff: the sum of (R + T)^n (1 + L S).
/// `reflects` and `refracts` are false for scenes without such surfaces; R or T is then left out.
[[nodiscard]] inline double rays_per_camera_ray(const DistributedSettings& settings,
                                                std::size_t lights, bool reflects = true,
                                                bool refracts = true) {
    double sum = 0;
    double rays = 1;
    for (int generation = 0; generation <= settings.recursion_limit; ++generation) {
        const auto samples = [&](int count) {
            return static_cast<double>(samples_at(count, generation, settings.falloff));
        };
        sum += rays * (1 + static_cast<double>(lights) * samples(settings.shadow_samples));
        rays *= (reflects ? samples(settings.reflection_samples) : 0) +
                (refracts ? samples(settings.refraction_samples) : 0);
    }
    return sum;
}

/// Settings with more rays for one camera ray are rejected, because a frame would hardly end.
inline constexpr double kMostRaysPerCameraRay = 1e7;

inline constexpr int kMostCameraSamples = 65536;

/// Camera rays per pixel.
[[nodiscard]] constexpr int camera_samples(const DistributedSettings& settings) {
    return settings.pixel_samples * settings.blur_samples * settings.lens_samples;
}

}  // namespace carom::render
