// Sums over a pixel's samples.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "render/frame/aov_planes.h"
#include "render/geometry/validity.h"
#include "render/integrator/integrator.h"
#include "render/light/area_light.h"

namespace carom::render {

/// Of the samples of one half of a pixel.
struct HalfSums {
    V3f radiance{0, 0, 0};
    V3f albedo{0, 0, 0};
    V3f normal{0, 0, 0};
    V3f light{0, 0, 0};
    int samples = 0;

    void add(const RadianceSample& sample) {
        radiance += sample.radiance;
        albedo += sample.albedo + sample.mirrored;
        normal += sample.normal;
        light += sample.light;
        samples += 1;
    }
};

/// In double, so that thousands of samples lose no precision. Samples are added in their order.
struct PixelSums {
    static constexpr int kGroups = 4;

    Vec3 radiance{0, 0, 0};
    Vec3 normal{0, 0, 0};
    Vec3 albedo{0, 0, 0};
    double coverage = 0;
    double luminance = 0;
    double luminance2 = 0;
    int samples = 0;  // that were added
    /// Sums of luminance over each quarter of the first samples; their differences estimate the
    /// noise.
    std::array<float, kGroups> groups{};
    /// How many samples hit which object; empty unless objects are counted.
    std::vector<ObjectCount> objects;
    /// Of the two halves of the samples; empty unless they are kept apart.
    std::vector<HalfSums> halves;

    /// Adds the sample to its half: even ones to the first.
    void add_to_half(const RadianceSample& sample) {
        halves.resize(2);
        halves[static_cast<std::size_t>(samples % 2)].add(sample);
    }

    /// Adds the sample with the index `samples`. `group`: the quarter that it belongs to, or -1.
    void add(const RadianceSample& sample, int group = -1) {
        CAROM_VALIDATE(is_light(sample.radiance) && is_finite(sample.normal) &&
                       is_light(sample.albedo));
        radiance += Vec3(sample.radiance);
        normal += Vec3(sample.normal);
        albedo += Vec3(sample.albedo);
        coverage += static_cast<double>(sample.coverage);
        const double y = static_cast<double>(carom::luminance(sample.radiance));
        luminance += y;
        luminance2 += y * y;
        samples += 1;
        if (group >= 0) {
            groups[static_cast<std::size_t>(group)] += static_cast<float>(y);
        }
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
        }
        return result;
    }
};

}  // namespace carom::render
