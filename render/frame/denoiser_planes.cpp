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
#include "render/frame/large_picture.h"

namespace carom::render {
namespace {

constexpr std::size_t kColours = 3;
constexpr std::size_t kFeatures = DenoiserValues::kFeatures;

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

DenoiserPlanes::DenoiserPlanes(int width, int height) : width_(width) {
    const auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    for (std::string& name : channel_names()) {
        channels_.push_back({std::move(name), {}});
        channels_.back().bits.reserve(pixels);
    }
}

void DenoiserPlanes::make_room(std::size_t pixels) {
    for (HalfChannel& channel : channels_) {
        channel.bits.resize(std::max(channel.bits.size(), pixels));
    }
}

// The loops over the pixels of a channel have no branches, so that compilers use vectors.
void DenoiserValues::set_colours(std::span<const DenoiserPixel> pixels) {
    CAROM_ASSERT(pixels.size() <= kMost);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const auto& [sums, traced, pixel] = pixels[i];
        const V3f difference = sums->mean_of_half(pixel, 0) - sums->mean_of_half(pixel, 1);
        for (std::size_t c = 0; c < kColours; ++c) {
            colours_[c][i] = 0.5F * difference[static_cast<int>(c)];
        }
        variance_[i] = sums->variance(pixel);
    }
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        for (Values& colour : colours_) {
            colour[i] = rounded<kNoiseDigits>(colour[i]);
        }
        variance_[i] = rounded<kVarianceDigits>(variance_[i]);
    }
}

void DenoiserValues::set_features(std::span<const DenoiserPixel> pixels) {
    CAROM_ASSERT(pixels.size() <= kMost);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const auto& [sums, traced, pixel] = pixels[i];
        const PixelFeatures halves[2] = {sums->features_of_half(pixel, 0),
                                         sums->features_of_half(pixel, 1)};
        const TracedFeatures rays = traced->at(pixel);
        const PixelFeatures means = rays.with_samples(halves, sums->samples(pixel));
        share_[i] = as_half(rays.share_of_samples(sums->samples(pixel)));
        for (std::size_t f = 0; f < kFeatures; ++f) {
            exact_[f][i] = means[f];
            error_[f][i] = 0.5F * (halves[0][f] + halves[1][f]);
            difference_[f][i] = 0.5F * (halves[0][f] - halves[1][f]);
        }
    }
    for (std::size_t f = 0; f < kFeatures; ++f) {
        const float step = f < PixelFeatures::kLight ? kExactStep : 0;
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            const float exact = exact_[f][i];
            const float mean = error_[f][i];
            exact_[f][i] = as_half(step > 0 ? stepped(exact, step) : exact);
            // Where all rays saw the same, the error is none, although the exact mean is rounded.
            const float error = rounded_feature(mean - exact_[f][i]);
            error_[f][i] = render::difference(mean, exact) == 0 ? 0 : error;
            difference_[f][i] = rounded_feature(difference_[f][i]);
        }
    }
}

/// Channel by channel: planes of a picture often begin at the same place of a page of memory, where
/// the processor's cache keeps few lines.
void DenoiserPlanes::write(std::span<const DenoiserPixel> pixels, std::size_t first,
                           std::size_t width) {
    DenoiserValues values;
    values.set_colours(pixels);
    values.set_features(pixels);
    const auto write = [&](std::size_t channel, const DenoiserValues::Values& from) {
        std::uint16_t* to = channels_[channel].bits.data() + first;
        for (std::size_t i = 0; i < pixels.size(); i += width) {
            std::transform(from.data() + i, from.data() + i + width, to, half_bits);
            to += width_;
        }
    };
    for (std::size_t c = 0; c < kColours; ++c) {
        write(c, values.difference_of_colour(c));
    }
    write(kVariance, values.variance());
    write(kShare, values.share());
    for (std::size_t f = 0; f < kFeatures; ++f) {
        write(kExact + f, values.exact(f));
        write(kError + f, values.error(f));
        write(kDifference + f, values.difference(f));
    }
}

float with_added_colour(float half, float added) {
    return added == 0 ? half : rounded<kNoiseDigits>(half + added);
}

void DenoiserPlanes::add_to_colours(const SplatPicture& a, const SplatPicture& b) {
    for (std::size_t c = 0; c < kColours; ++c) {
        const auto axis = static_cast<int>(c);
        std::vector<std::uint16_t>& bits = channels_[c].bits;
        for (std::size_t i = 0; i < bits.size(); ++i) {
            const int x = static_cast<int>(i % static_cast<std::size_t>(width_));
            const int y = static_cast<int>(i / static_cast<std::size_t>(width_));
            bits[i] = half_bits(with_added_colour(imath_half_to_float(bits[i]),
                                                  0.5F * (a.at(x, y)[axis] - b.at(x, y)[axis])));
        }
    }
}

namespace {

DenoiseInput input_of(const Film& film) {
    const std::vector<std::string> names = channel_names();
    if (!std::ranges::equal(film.half_aovs, names, {}, &HalfChannel::name)) {
        throw Error("a frame without the channels for the denoiser cannot be denoised");
    }
    std::vector<PlaneView> views;
    for (const HalfChannel& channel : film.half_aovs) {
        views.push_back({.halves = channel.bits.data()});
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
    return error_after_denoising(PlaneSource(input_of(film)), context);
}

Film denoised(const Film& film, const WorkContext& context) {
    const DenoisedPicture picture = denoise(input_of(film), context);
    give_back_memory_of(picture.error.size());  // before there are more copies of the picture
    Film result;
    result.width = film.width;
    result.height = film.height;
    result.rgba = film.rgba;
    for (std::size_t i = 0; i < picture.error.size(); ++i) {
        std::copy_n(&picture.rgb[kColours * i], kColours, &result.rgba[4 * i]);
    }
    result.aovs = film.aovs;
    result.notes = film.notes;
    result.statistics = film.statistics;
    return result;
}

}  // namespace carom::render
