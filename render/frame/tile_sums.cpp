#include "render/frame/tile_sums.h"

#include <algorithm>

#include "core/colour.h"
#include "core/vectors.h"

namespace carom::render {
namespace {

bool asks_for(const RenderSettings& settings, const char* aov) {
    return std::ranges::find(settings.aovs, aov) != settings.aovs.end();
}

/// In double, so that it is the same of a sum as the sum of the samples'.
double luminance_of(double red, double green, double blue) {
    return static_cast<double>(kRedLuminance) * red + static_cast<double>(kGreenLuminance) * green +
           static_cast<double>(kBlueLuminance) * blue;
}

}  // namespace

SumsKind SumsKind::needed_by(const RenderSettings& settings) {
    SumsKind kind;
    kind.halves = has_halves(settings);
    kind.variance = settings.for_denoiser || asks_for(settings, "variance");
    kind.surfaces = asks_for(settings, "normal") || asks_for(settings, "albedo") ||
                    asks_for(settings, "roughness");
    kind.features = settings.for_denoiser;
    kind.objects = std::ranges::any_of(settings.aovs, is_matte);
    return kind;
}

SumsKind SumsKind::for_all_aovs(const RenderSettings& settings) {
    SumsKind kind = needed_by(settings);
    kind.variance = true;
    kind.surfaces = true;
    return kind;
}

TracedTile::TracedTile(std::span<const FeaturePixel> pixels) : place_(pixels.size()) {
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const TracedFeatures& traced = pixels[i].traced;
        if (traced.rays > 0) {
            rays_.push_back(static_cast<std::uint16_t>(traced.rays));
            sums_.insert(sums_.end(), traced.sum.values.begin(),
                         traced.sum.values.begin() + PixelFeatures::kCount);
            place_[i] = static_cast<std::uint16_t>(rays_.size());
        }
    }
    rays_.shrink_to_fit();
    sums_.shrink_to_fit();
}

TracedFeatures TracedTile::at(std::size_t pixel) const {
    TracedFeatures result;
    if (const std::size_t place = place_[pixel]; place > 0) {
        result.rays = rays_[place - 1];
        std::copy_n(&sums_[(place - 1) * PixelFeatures::kCount], PixelFeatures::kCount,
                    result.sum.values.begin());
    }
    return result;
}

bool TracedTile::is_valid(std::size_t pixels) const {
    return (place_.empty() || place_.size() == pixels) &&
           sums_.size() == PixelFeatures::kCount * rays_.size() &&
           std::ranges::all_of(place_, [&](std::size_t place) { return place <= rays_.size(); });
}

TileSums::TileSums(std::size_t pixels, const SumsKind& kind)
    : kind_(kind),
      samples_(pixels),
      radiance_(3 * pixels),
      coverage_(pixels),
      squares_(kind.variance ? pixels : 0),
      differences_(kind.halves ? 3 * pixels : 0),
      surfaces_(kind.surfaces ? 7 * pixels : 0),
      objects_(kind.objects ? pixels : 0) {}

std::size_t TileSums::bytes() const {
    std::size_t bytes = 0;
    for_each_plane(*this, [&](const auto& plane) { bytes += plane.size() * sizeof(plane[0]); });
    return bytes;
}

bool TileSums::is_valid(bool has_plan) const {
    const std::size_t pixels = samples_.size();
    const auto fits = [&](const auto& plane, std::size_t numbers, bool is_kept) {
        return plane.size() == (is_kept ? numbers * pixels : 0);
    };
    return fits(radiance_, 3, true) && fits(coverage_, 1, true) &&
           fits(squares_, 1, kind_.variance) && fits(differences_, 3, kind_.halves) &&
           fits(surfaces_, 7, kind_.surfaces) && fits(objects_, 1, kind_.objects) &&
           std::ranges::all_of(features_,
                               [&](const auto& plane) {
                                   return plane.empty() || fits(plane, 3, kind_.features);
                               }) &&
           fits(planned, 1, has_plan) && (pixels > 0 || !has_plan) && traced.is_valid(pixels);
}

void TileSums::add(std::size_t pixel, std::span<const RadianceSample> samples) {
    double light[3] = {};
    for (std::size_t c = 0; c < 3; ++c) {
        light[c] = radiance_[c * size() + pixel];
    }
    float coverage = coverage_[pixel];
    for (const RadianceSample& sample : samples) {
        for (int c = 0; c < 3; ++c) {
            light[c] += static_cast<double>(sample.radiance[c]);
        }
        coverage += sample.coverage;
    }
    for (std::size_t c = 0; c < 3; ++c) {
        radiance_[c * size() + pixel] = light[c];
    }
    coverage_[pixel] = coverage;
    if (kind_ == SumsKind()) {
        samples_[pixel] += static_cast<int>(samples.size());
        return;
    }
    for (const RadianceSample& sample : samples) {
        add_details(pixel, sample);
    }
}

/// Adds what the frame needs to know besides light and coverage, and counts the sample.
void TileSums::add_details(std::size_t pixel, const RadianceSample& sample) {
    const std::size_t pixels = size();
    const bool is_first_half = samples_[pixel] % 2 == 0;
    for (std::size_t c = 0; c < 3; ++c) {
        const int axis = static_cast<int>(c);
        if (kind_.halves) {
            const float light = sample.radiance[axis];
            differences_[c * pixels + pixel] += is_first_half ? light : -light;
        }
        if (kind_.surfaces) {
            surfaces_[c * pixels + pixel] += static_cast<double>(sample.normal[axis]);
            surfaces_[(3 + c) * pixels + pixel] += static_cast<double>(sample.albedo[axis]);
        }
    }
    if (kind_.surfaces) {
        surfaces_[6 * pixels + pixel] += static_cast<double>(sample.roughness);
    }
    if (kind_.variance) {
        const Vec3 light(sample.radiance);
        const double y = luminance_of(light.x, light.y, light.z);
        squares_[pixel] += y * y;
    }
    if (kind_.features) {
        add_features(pixel, sample);
    }
    if (kind_.objects) {
        count_object(pixel, sample.object);
    }
    samples_[pixel] += 1;
}

void TileSums::add_features(std::size_t pixel, const RadianceSample& sample) {
    const PixelFeatures features = PixelFeatures::of(sample);
    const auto half = static_cast<std::size_t>(samples_[pixel] % 2);
    for (std::size_t group = 0; group < kGroups; ++group) {
        std::vector<float>& planes = features_[half * kGroups + group];
        const float* values = &features.values[3 * group];
        if (planes.empty() && values[0] == 0 && values[1] == 0 && values[2] == 0) {
            continue;
        }
        planes.resize(3 * size());
        for (std::size_t i = 0; i < 3; ++i) {
            planes[i * size() + pixel] += values[i];
        }
    }
}

void TileSums::count_object(std::size_t pixel, std::uint32_t object) {
    std::vector<ObjectCount>& objects = objects_[pixel];
    const auto known = std::ranges::find(objects, object, &ObjectCount::object);
    if (known != objects.end()) {
        known->samples += 1;
    } else if (object != kNoObject) {
        objects.push_back({object, 1});
    }
}

V3f TileSums::mean(std::size_t pixel) const {
    if (samples_[pixel] == 0) {
        return V3f(0, 0, 0);
    }
    const double scale = 1.0 / samples_[pixel];
    const auto channel = [&](std::size_t c) {
        return static_cast<float>(radiance_[c * size() + pixel] * scale);
    };
    return {channel(0), channel(1), channel(2)};
}

float TileSums::coverage(std::size_t pixel) const {
    return samples_[pixel] > 0
               ? static_cast<float>(static_cast<double>(coverage_[pixel]) * (1.0 / samples_[pixel]))
               : 0.0F;
}

V3f TileSums::mean_of_half(std::size_t pixel, int half) const {
    const int count = samples_of_half(pixel, half);
    if (count == 0 || !kind_.halves) {
        return V3f(0, 0, 0);
    }
    const auto channel = [&](std::size_t c) {
        const auto difference = static_cast<double>(differences_[c * size() + pixel]);
        const double sum = radiance_[c * size() + pixel];
        return static_cast<float>(0.5 * (half == 0 ? sum + difference : sum - difference) / count);
    };
    return {channel(0), channel(1), channel(2)};
}

PixelFeatures TileSums::features_of_half(std::size_t pixel, int half) const {
    PixelFeatures result;
    const int count = samples_of_half(pixel, half);
    if (count == 0) {
        return result;
    }
    const float scale = 1.0F / static_cast<float>(count);
    for (std::size_t group = 0; group < kGroups; ++group) {
        const auto& planes = features_[static_cast<std::size_t>(half) * kGroups + group];
        for (std::size_t i = 0; i < 3 && !planes.empty(); ++i) {
            result.values[3 * group + i] = planes[i * size() + pixel] * scale;
        }
    }
    return result;
}

float TileSums::variance(std::size_t pixel) const {
    const int samples = samples_[pixel];
    if (samples < 2 || !kind_.variance) {
        return 0;
    }
    const double* sum = &radiance_[pixel];
    const double mean = luminance_of(sum[0], sum[size()], sum[2 * size()]) / samples;
    return static_cast<float>(std::max(0.0, squares_[pixel] / samples - mean * mean) /
                              (samples - 1));
}

PixelMeans TileSums::means(std::size_t pixel) const {
    PixelMeans result;
    result.samples = samples_[pixel];
    result.variance = variance(pixel);
    if (kind_.objects) {
        result.objects = objects_[pixel];
    }
    if (kind_.surfaces) {
        const auto mean = [&](std::size_t plane) {
            return static_cast<float>(surfaces_[plane * size() + pixel] / result.samples);
        };
        result.normal = {mean(0), mean(1), mean(2)};
        result.albedo = {mean(3), mean(4), mean(5)};
        result.roughness = mean(6);
    }
    if (result.samples > 1) {
        const float difference = 0.5F * (carom::luminance(mean_of_half(pixel, 0)) -
                                         carom::luminance(mean_of_half(pixel, 1)));
        result.squared_difference = difference * difference;
    }
    return result;
}

}  // namespace carom::render
