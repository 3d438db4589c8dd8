// Sums over the samples of a tile's pixels.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "render/frame/aov_planes.h"
#include "render/frame/feature_tracer.h"
#include "render/frame/pixel_features.h"
#include "render/integrator/integrator.h"

namespace carom::render {

/// What a frame needs to know of its samples besides their light and coverage.
struct SumsKind {
    bool halves = false;    // the light of the two halves of the samples, with even and odd indices
    bool variance = false;  // of the luminance
    bool surfaces = false;  // normals, albedos and roughnesses
    bool features = false;  // what the two halves saw, for the denoiser
    bool objects = false;   // which ones were hit

    [[nodiscard]] static SumsKind needed_by(const RenderSettings& settings);
    /// For any AOV, except mattes that the settings do not ask for.
    [[nodiscard]] static SumsKind for_all_aovs(const RenderSettings& settings);
    bool operator==(const SumsKind&) const = default;
};

/// What camera rays saw of a tile's pixels. Most pixels have no rays.
class TracedTile {
  public:
    TracedTile() = default;
    explicit TracedTile(std::span<const FeaturePixel> pixels);

    /// Whether nothing was traced, not even for pixels that turned out to need no rays.
    [[nodiscard]] bool empty() const { return place_.empty(); }
    [[nodiscard]] TracedFeatures at(std::size_t pixel) const;

    template <class Self, class Visit>
    static void for_each_plane(Self& self, const Visit& visit) {
        visit(self.place_);
        visit(self.rays_);
        visit(self.sums_);
    }
    [[nodiscard]] bool is_valid(std::size_t pixels) const;

  private:
    std::vector<std::uint16_t> place_;  // by pixel: 1 + its place in the following ones, or 0
    std::vector<std::uint16_t> rays_;   // of pixels with rays
    std::vector<float> sums_;           // of these, PixelFeatures::kCount each
};

/// A plane for each number, of all pixels of a tile, row by row. Sums of light are double, so that
/// thousands of samples lose no precision; those of features are float. Samples are added in their
/// order. Planes that the frame does not need take no memory, nor do features that are 0 all over.
class TileSums {
  public:
    /// No pixels.
    TileSums() = default;
    TileSums(std::size_t pixels, const SumsKind& kind);

    [[nodiscard]] bool empty() const { return samples_.empty(); }
    [[nodiscard]] std::size_t size() const { return samples_.size(); }
    [[nodiscard]] const SumsKind& kind() const { return kind_; }
    [[nodiscard]] std::size_t bytes() const;

    /// Adds the samples of a pixel from the index samples(pixel) on.
    void add(std::size_t pixel, std::span<const RadianceSample> samples);

    [[nodiscard]] int samples(std::size_t pixel) const { return samples_[pixel]; }
    /// Of each pixel after the current round of adaptive sampling (sample_plan.h); empty before.
    std::vector<int> planned{};
    TracedTile traced{};  // with adaptive sampling for the denoiser

    /// Means; 0 of pixels and halves without samples.
    [[nodiscard]] V3f mean(std::size_t pixel) const;
    [[nodiscard]] float coverage(std::size_t pixel) const;
    [[nodiscard]] V3f mean_of_half(std::size_t pixel, int half) const;
    [[nodiscard]] PixelFeatures features_of_half(std::size_t pixel, int half) const;
    /// Of the mean luminance, as if samples were independent.
    [[nodiscard]] float variance(std::size_t pixel) const;
    /// For the AOVs, of a pixel with samples.
    [[nodiscard]] PixelMeans means(std::size_t pixel) const;

    /// Calls visit(plane) with each vector of numbers, also with empty ones.
    template <class Self, class Visit>
    static void for_each_plane(Self& self, const Visit& visit) {
        visit(self.samples_);
        visit(self.radiance_);
        visit(self.coverage_);
        visit(self.squares_);
        visit(self.differences_);
        visit(self.surfaces_);
        for (auto& features : self.features_) {
            visit(features);
        }
        for (auto& objects : self.objects_) {
            visit(objects);
        }
        visit(self.planned);
        TracedTile::for_each_plane(self.traced, visit);
    }
    /// Whether the planes, which may come from a file, are those of such a tile.
    [[nodiscard]] bool is_valid(bool has_plan) const;

  private:
    static constexpr std::size_t kGroups = PixelFeatures::kCount / 3;

    [[nodiscard]] int samples_of_half(std::size_t pixel, int half) const {
        return (samples_[pixel] + 1 - half) / 2;
    }
    void add_details(std::size_t pixel, const RadianceSample& sample);
    void add_features(std::size_t pixel, const RadianceSample& sample);
    void count_object(std::size_t pixel, std::uint32_t object);

    SumsKind kind_;
    std::vector<int> samples_;
    std::vector<double> radiance_;    // red of all pixels, then green, then blue
    std::vector<float> coverage_;     // of which each sample has 0 or 1
    std::vector<double> squares_;     // of the luminance
    std::vector<float> differences_;  // of the colours' sums: first half - second half
    std::vector<double> surfaces_;    // the axes of normals, the colours of albedos, the roughness
    /// Albedo, normal and light of the first half, then of the second; each of three planes.
    std::array<std::vector<float>, 2 * kGroups> features_;
    std::vector<std::vector<ObjectCount>> objects_;  // by pixel
};

}  // namespace carom::render
