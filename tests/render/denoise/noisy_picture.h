// Made-up noisy pictures with features, for tests of the denoiser.
#pragma once

#include <cstdint>
#include <functional>
#include <random>
#include <vector>

#include "render/denoise/denoise.h"

namespace carom::render::test {

/// Normally distributed numbers, the same with every standard library (Irwin and Hall: the sum of
/// twelve uniform numbers).
class Noise {
  public:
    explicit Noise(std::uint32_t seed) : engine_(seed) {}
    float operator()(float deviation) {
        float sum = -6;
        for (int i = 0; i < 12; ++i) {
            sum += static_cast<float>(engine_() >> 8) / static_cast<float>(1u << 24);
        }
        return deviation * sum;
    }

  private:
    std::mt19937 engine_;
};

/// A picture with the numbers that DenoiseInput refers to.
class NoisyPicture {
  public:
    static constexpr std::size_t kFeatures = 9;
    using Value = std::function<float(int x, int y)>;

    NoisyPicture(int width, int height);

    int width, height;
    std::vector<float> truth[3];       // of the colours, row by row
    std::vector<float> mean[3];        // of both halves
    std::vector<float> difference[3];  // half of that between them
    std::vector<float> exact[kFeatures];
    std::vector<float> error[kFeatures];
    std::vector<float> feature_difference[kFeatures];
    std::vector<float> variance;  // empty: not known
    std::vector<float> share;     // of the samples in the exact features; empty: none

    /// Sets a channel's truth in both halves.
    void set_colour(int channel, const Value& value);
    /// Sets a feature, in both halves as it is.
    void set_feature(int feature, const Value& value);
    /// Adds independent noise to both halves of all colours.
    void add_noise(Noise& noise, float deviation);
    /// The same with a deviation for each pixel.
    void add_noise(Noise& noise, const Value& deviation);
    /// Adds noise to a feature of both halves, and `slope` times that noise to all colours.
    void add_feature_noise(Noise& noise, int feature, float deviation, float slope);

    /// Mixes this share of the samples' means into the exact features.
    void mix_samples_into_exact(float part);

    [[nodiscard]] DenoiseInput input() const;
    /// The part of the picture that begins at (x, y).
    [[nodiscard]] NoisyPicture part(int x, int y, int part_width, int part_height) const;

    [[nodiscard]] double noisy_error() const;  // mean square
    [[nodiscard]] double error_of(const DenoisedPicture& picture) const;
    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(x);
    }

  private:
    template <class Visit>
    void for_each_pixel(const Visit& visit) const;
};

/// Shaded discs of different colours on a textured ground, with noise in colours and features. In
/// places there is a texture that no feature knows.
[[nodiscard]] NoisyPicture discs(int width, int height, std::uint32_t seed);

}  // namespace carom::render::test
