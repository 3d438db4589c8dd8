// Sums over a pixel's samples.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "render/frame/aov_planes.h"
#include "render/frame/pixel_features.h"
#include "render/geometry/validity.h"
#include "render/integrator/integrator.h"
#include "render/light/area_light.h"

namespace carom::render {

/// In double, so that thousands of samples lose no precision. Samples are added in their order.
struct PixelSums {
    Vec3 radiance{0, 0, 0};
    Vec3 normal{0, 0, 0};
    Vec3 albedo{0, 0, 0};
    double coverage = 0;
    double luminance = 0;
    double luminance2 = 0;
    int samples = 0;  // that were added
    /// Sums of radiance over the two halves of the samples: those with even and with odd indices.
    std::array<V3f, 2> half_radiance{};
    /// How many samples hit which object; empty unless objects are counted.
    std::vector<ObjectCount> objects;
    /// Sums of what the two halves saw; 0 unless it is for the denoiser.
    std::array<PixelFeatures, 2> halves{};

    /// Adds what the sample with the index `samples` saw to its half.
    void add_to_half(const RadianceSample& sample) {
        halves[static_cast<std::size_t>(samples % 2)] += PixelFeatures::of(sample);
    }

    /// The number of samples of a half.
    [[nodiscard]] int samples_of_half(int half) const { return (samples + 1 - half) / 2; }

    /// The mean radiance of a half; 0 if it has no samples.
    [[nodiscard]] V3f mean_of_half(int half) const {
        const int count = samples_of_half(half);
        return count > 0 ? half_radiance[static_cast<std::size_t>(half)] / static_cast<float>(count)
                         : V3f(0, 0, 0);
    }

    /// Adds the sample with the index `samples`.
    void add(const RadianceSample& sample) {
        CAROM_VALIDATE(is_light(sample.radiance) && is_finite(sample.normal) &&
                       is_light(sample.albedo));
        radiance += Vec3(sample.radiance);
        half_radiance[static_cast<std::size_t>(samples % 2)] += sample.radiance;
        normal += Vec3(sample.normal);
        albedo += Vec3(sample.albedo);
        coverage += static_cast<double>(sample.coverage);
        const double y = static_cast<double>(carom::luminance(sample.radiance));
        luminance += y;
        luminance2 += y * y;
        samples += 1;
    }

    void count_object(std::uint32_t object) {
        const auto known =
            std::find_if(objects.begin(), objects.end(),
                         [&](const ObjectCount& entry) { return entry.object == object; });
        if (known != objects.end()) {
            known->samples += 1;
        } else if (object != kNoObject) {
            objects.push_back({object, 1});
        }
    }

    /// Needs at least one sample.
    [[nodiscard]] PixelMeans means() const {
        PixelMeans result;
        result.objects = objects;
        result.samples = samples;
        result.normal = V3f(normal / samples);
        result.albedo = V3f(albedo / samples);
        const double mean = luminance / samples;
        if (samples > 1) {
            result.variance = static_cast<float>(std::max(0.0, luminance2 / samples - mean * mean) /
                                                 (samples - 1));
            const float difference =
                0.5F * (carom::luminance(mean_of_half(0)) - carom::luminance(mean_of_half(1)));
            result.squared_difference = difference * difference;
        }
        return result;
    }
};

}  // namespace carom::render
