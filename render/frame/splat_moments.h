// The noise of light that is splatted onto pixels.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace carom::render {

/// Sums of what splats (light_tracer.h) add to the luminance of pixels, and their variance. The
/// samples of an image are a low-discrepancy set, for which a variance as of independent samples
/// would be 5 to 15 times too high. Instead, the sums over its quarters are compared, each of which
/// is such a set. An image has edges, at which the variance of well-spread samples falls with the
/// power -3/2 of their number (Mitchell 1996, "Consequences of stratified sampling in graphics"),
/// so that of the whole is an eighth of a quarter's.
class SplatMoments {
  public:
    static constexpr int kQuarters = 4;

    /// Of no pixels.
    SplatMoments() = default;
    explicit SplatMoments(std::size_t pixels)
        : mean_(pixels), variance_(pixels), entry_of_(pixels, -1) {}

    [[nodiscard]] bool empty() const { return mean_.empty(); }

    /// Adds what a sample in one quarter of an image's samples contributes to a pixel.
    void add(std::size_t pixel, int quarter, float luminance);
    /// Ends an image. The picture gets `weight` times the sum of what was added.
    void finish_image(float weight);

    /// Luminance by pixel, of all images.
    [[nodiscard]] const std::vector<float>& mean() const { return mean_; }
    /// Its variance.
    [[nodiscard]] const std::vector<float>& variance() const { return variance_; }

  private:
    struct Entry {
        std::size_t pixel = 0;
        std::array<float, kQuarters> sums{};
    };

    std::vector<float> mean_, variance_;
    // Of the current image.
    std::vector<std::int32_t> entry_of_;  // by pixel, or -1
    std::vector<Entry> entries_;
};

}  // namespace carom::render
