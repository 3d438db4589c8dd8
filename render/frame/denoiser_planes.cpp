#include "render/frame/denoiser_planes.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>

#include "core/assert.h"
#include "core/error.h"
#include "render/denoise/denoise.h"
#include "render/film/half_float.h"

namespace carom::render {
namespace {

constexpr std::size_t kColours = 3;
constexpr std::size_t kFeatures = PixelFeatures::kCount;

constexpr std::array<std::string_view, 9> kFeatureNames{"albedo.R", "albedo.G", "albedo.B",
                                                        "normal.X", "normal.Y", "normal.Z",
                                                        "light.R",  "light.G",  "light.B"};

// The order of the channels.
constexpr std::size_t kVariance = kColours;
constexpr std::size_t kExact = kVariance + 1;
constexpr std::size_t kError = kExact + kFeatures;
constexpr std::size_t kDifference = kError + kFeatures;
constexpr std::size_t kShare = kDifference + kFeatures;

std::vector<std::string> channel_names() {
    std::vector<std::string> names{"half.R", "half.G", "half.B", "half_variance.X"};
    for (const char* kind : {"exact_", "error_", "half_"}) {
        for (const std::string_view feature : kFeatureNames) {
            names.push_back(kind + std::string(feature));
        }
    }
    names.emplace_back("exact_share.X");
    return names;
}

constexpr int kHalfDigits = 11;

/// The nearest half float with at most this many binary digits, of which there are at most 11.
template <int kDigits>
float rounded(float value) {
    constexpr float kLargest = 65536 - (1 << (16 - kDigits));
    constexpr int kDropped = 24 - kDigits;
    constexpr float kStep = static_cast<float>(1 << (kHalfDigits - kDigits)) / (1 << 24);
    // Adding this number leaves multiples of kStep, which half floats below their least normal one
    // are.
    constexpr float kRounding = 1.5F * (1 << 23) * kStep;
    value = std::clamp(value, -kLargest, kLargest);
    const auto bits = std::bit_cast<std::uint32_t>(value);
    const auto normal =
        std::bit_cast<float>((bits + (1u << (kDropped - 1))) >> kDropped << kDropped);
    const float small = (value + kRounding) - kRounding;
    return std::abs(value) < half_float::kLeastNormal ? small : normal;
}

/// A difference of two means that are equal but for their rounding counts as none.
float difference(float a, float b) {
    constexpr float kRounding = 2e-6F;
    const float result = a - b;
    return std::abs(result) <= kRounding * (1 + std::abs(a)) ? 0 : result;
}

// Chosen for size: a frame of 1080p takes 23 MB more than without these channels, instead of 43 MB
// with 6 bits and no steps. What is lost is small against the noise that the numbers describe.
constexpr int kNoiseDigits = 4;
constexpr int kVarianceDigits = 2;
constexpr float kStep = 1.0F / 512;        // of differences of features
constexpr float kExactStep = 1.0F / 4096;  // of albedo and normal

/// The nearest multiple of `step`, if there are fewer than 2^22 steps.
float stepped(float value, float step) {
    const float rounding = 1.5F * (1 << 23) * step;
    return std::abs(value) < (1 << 22) * step ? (value + rounding) - rounding : value;
}

float rounded_feature(float value) {
    return rounded<kNoiseDigits>(stepped(value, kStep));
}

}  // namespace

PixelFeatures features_of_half(const PixelSums& pixel, int half) {
    const int samples = pixel.samples_of_half(half);
    return samples > 0
               ? pixel.halves[static_cast<std::size_t>(half)] * (1.0F / static_cast<float>(samples))
               : PixelFeatures();
}

DenoiserPlanes::DenoiserPlanes(int width, int height) : width_(width) {
    const auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    for (std::string& name : channel_names()) {
        channels_.push_back({std::move(name), std::vector<float>(pixels), true});
    }
}

namespace {

using Values = std::array<float, DenoiserPlanes::kMost>;

/// Values of some pixels before they are rounded.
struct Unrounded {
    std::array<Values, kColours> difference_of_colour{};
    Values variance{};
    Values share{};
    std::array<Values, kFeatures> exact{}, mean{}, difference{};

    void set(std::size_t i, const FeaturePixel& pixel, const PixelSums& sums) {
        const V3f colours = sums.mean_of_half(0) - sums.mean_of_half(1);
        const PixelFeatures means = pixel.traced.with_samples(pixel.halves, sums.samples);
        for (std::size_t c = 0; c < kColours; ++c) {
            difference_of_colour[c][i] = 0.5F * colours[static_cast<int>(c)];
        }
        variance[i] = sums.samples > 0 ? sums.means().variance : 0;
        share[i] = pixel.traced.share_of_samples(sums.samples);
        for (std::size_t f = 0; f < kFeatures; ++f) {
            exact[f][i] = means[f];
            mean[f][i] = 0.5F * (pixel.halves[0][f] + pixel.halves[1][f]);
            difference[f][i] = 0.5F * (pixel.halves[0][f] - pixel.halves[1][f]);
        }
    }
};

}  // namespace

/// Channel by channel: planes of a picture often begin at the same place of a page of memory, where
/// the processor's cache keeps few lines. The loops have no branches, so that compilers use
/// vectors.
void DenoiserPlanes::write(std::span<const FeaturePixel> pixels, std::size_t width,
                           const PixelSums* sums, std::size_t row) {
    CAROM_ASSERT(!pixels.empty() && pixels.size() <= kMost);
    Unrounded all;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        all.set(i, pixels[i], sums[i / width * row + i % width]);
    }
    const std::size_t first =
        static_cast<std::size_t>(pixels.front().y) * static_cast<std::size_t>(width_) +
        static_cast<std::size_t>(pixels.front().x);
    Values values;
    const auto write = [&](std::size_t channel, const auto& value) {
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            values[i] = value(i);
        }
        float* to = channels_[channel].values.data() + first;
        for (std::size_t i = 0; i < pixels.size(); i += width) {
            std::copy_n(values.data() + i, width, to);
            to += width_;
        }
    };
    for (std::size_t c = 0; c < kColours; ++c) {
        write(c,
              [&](std::size_t i) { return rounded<kNoiseDigits>(all.difference_of_colour[c][i]); });
    }
    write(kVariance, [&](std::size_t i) { return rounded<kVarianceDigits>(all.variance[i]); });
    write(kShare, [&](std::size_t i) { return as_half(all.share[i]); });
    for (std::size_t f = 0; f < kFeatures; ++f) {
        const Values& exact = all.exact[f];
        const Values& mean = all.mean[f];
        if (f >= PixelFeatures::kLight) {
            write(kExact + f, [&](std::size_t i) { return as_half(exact[i]); });
        } else {
            write(kExact + f,
                  [&](std::size_t i) { return as_half(stepped(exact[i], kExactStep)); });
        }
        const Values kept = values;
        write(kError + f, [&](std::size_t i) {
            // Where all rays saw the same, the error is none, although the exact mean is rounded.
            const float error = rounded_feature(mean[i] - kept[i]);
            return difference(mean[i], exact[i]) == 0 ? 0 : error;
        });
        write(kDifference + f,
              [&](std::size_t i) { return rounded_feature(all.difference[f][i]); });
    }
}

void DenoiserPlanes::add_to_colours(const Film& a, const Film& b) {
    for (std::size_t c = 0; c < kColours; ++c) {
        std::vector<float>& values = channels_[c].values;
        for (std::size_t i = 0; i < values.size(); ++i) {
            const float added = 0.5F * (a.rgba[4 * i + c] - b.rgba[4 * i + c]);
            values[i] = added == 0 ? values[i] : rounded<kNoiseDigits>(values[i] + added);
        }
    }
}

void DenoiserPlanes::append_to(Film& film) {
    for (Channel& channel : channels_) {
        film.aovs.push_back(std::move(channel));
    }
    channels_.clear();
}

bool is_denoiser_channel(std::string_view name) {
    static const std::vector<std::string> names = channel_names();
    return std::find(names.begin(), names.end(), name) != names.end();
}

namespace {

DenoiseInput input_of(const Film& film) {
    std::vector<PlaneView> views;
    for (const std::string& name : channel_names()) {
        const auto found =
            std::find_if(film.aovs.begin(), film.aovs.end(),
                         [&](const Channel& channel) { return channel.name == name; });
        if (found == film.aovs.end()) {
            throw Error("a frame without the channel '" + name + "' cannot be denoised");
        }
        views.push_back({found->values.data()});
    }
    DenoiseInput input;
    input.width = film.width;
    input.height = film.height;
    for (std::size_t c = 0; c < kColours; ++c) {
        input.colour[c] = {{film.rgba.data() + c, 4}, views[c]};
    }
    input.variance = views[kVariance];
    for (std::size_t f = 0; f < kFeatures; ++f) {
        input.features.push_back({views[kExact + f], views[kError + f], views[kDifference + f]});
    }
    input.share_of_samples = views[kShare];
    return input;
}

}  // namespace

std::vector<float> error_after_denoising(const Film& film, const WorkContext& context) {
    return denoise(input_of(film), context).error;
}

Film denoised(const Film& film, const WorkContext& context) {
    const DenoisedPicture picture = denoise(input_of(film), context);
    Film result;
    result.width = film.width;
    result.height = film.height;
    result.rgba = film.rgba;
    for (std::size_t i = 0; i < picture.error.size(); ++i) {
        std::copy_n(&picture.rgb[kColours * i], kColours, &result.rgba[4 * i]);
    }
    std::copy_if(film.aovs.begin(), film.aovs.end(), std::back_inserter(result.aovs),
                 [](const Channel& channel) { return !is_denoiser_channel(channel.name); });
    result.notes = film.notes;
    result.statistics = film.statistics;
    return result;
}

}  // namespace carom::render
