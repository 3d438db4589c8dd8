#include "pipeline/studio/channel_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "core/error.h"
#include "pipeline/video/tone_curve.h"
#include "render/frame/aov_planes.h"

namespace carom::studio {
namespace {

using Colour = std::array<double, 3>;

constexpr double kNoiseWhite = 0.2;   // the relative error that is shown as the last colour
constexpr double kDarkest = 1e-3;     // luminance; darker pixels are compared with it
constexpr double kPercentile = 0.01;  // of the depths, that lie outside of the scale
constexpr int kSamplesOfMeans = 16;   // after which normals and albedo are smooth enough
constexpr std::array<Colour, 5> kHeat{{{0.02, 0.02, 0.10},
                                       {0.30, 0.08, 0.45},
                                       {0.80, 0.22, 0.32},
                                       {0.98, 0.65, 0.20},
                                       {1.00, 1.00, 0.85}}};

std::uint8_t to_byte(double value) {
    return static_cast<std::uint8_t>(std::lround(255 * std::clamp(value, 0.0, 1.0)));
}

/// Calls `colour_of` with the index of each pixel.
template <class ColourOf>
std::vector<std::uint8_t> paint(std::size_t pixels, const ColourOf& colour_of) {
    std::vector<std::uint8_t> rgba(4 * pixels, 255);
    for (std::size_t i = 0; i < pixels; ++i) {
        const Colour colour = colour_of(i);
        for (std::size_t c = 0; c < 3; ++c) {
            rgba[4 * i + c] = to_byte(colour[c]);
        }
    }
    return rgba;
}

ChannelPicture depth_picture(const std::vector<float>& depth) {
    std::vector<float> seen;
    std::ranges::copy_if(depth, std::back_inserter(seen),
                         [](float z) { return z > 0 && z < render::kFarDepth; });
    if (seen.empty()) {
        return {paint(depth.size(), [](std::size_t) { return Colour{}; }),
                "The camera sees only the background."};
    }
    const auto at = [&](double part) {
        const auto place =
            seen.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(seen.size() - 1));
        std::nth_element(seen.begin(), place, seen.end());
        return static_cast<double>(*place);
    };
    const double near = at(kPercentile);
    const double far = std::max(at(1 - kPercentile), near * 1.001);
    const double scale = 1 / std::log(far / near);
    auto rgba = paint(depth.size(), [&](std::size_t i) {
        if (!(depth[i] < render::kFarDepth)) {
            return Colour{};
        }
        const double grey =
            1 - 0.9 * std::clamp(std::log(double{depth[i]} / near) * scale, 0.0, 1.0);
        return Colour{grey, grey, grey};
    });
    return {std::move(rgba),
            fmt::format("Distance along the camera's axis: {:.3g} m is white, {:.3g} m dark.", near,
                        far)};
}

/// Indices that follow each other get colours that differ much: hues a golden angle apart.
Colour colour_of_index(float index) {
    if (index < 0.5F) {
        return {};
    }
    const double golden = std::numbers::pi * (3 - std::sqrt(5.0));
    const double hue = golden * static_cast<double>(index);
    const double light = std::fmod(0.37 * static_cast<double>(index), 1.0) * 0.35 + 0.5;
    Colour colour{};
    for (std::size_t c = 0; c < 3; ++c) {
        const double turn = 2 * std::numbers::pi / 3 * static_cast<double>(c);
        colour[c] = light * (0.62 + 0.38 * std::cos(hue - turn));
    }
    return colour;
}

Colour heat(double part) {
    const double place = std::clamp(part, 0.0, 1.0) * (kHeat.size() - 1);
    const auto first = std::min(static_cast<std::size_t>(place), kHeat.size() - 2);
    const double rest = place - static_cast<double>(first);
    Colour colour{};
    for (std::size_t c = 0; c < 3; ++c) {
        colour[c] = (1 - rest) * kHeat[first][c] + rest * kHeat[first + 1][c];
    }
    return colour;
}

ChannelPicture noise_picture(const std::vector<float>& variance, const render::Film& colours) {
    const auto luminance = [&](std::size_t i) {
        const float* rgb = &colours.rgba[4 * i];
        return 0.2126 * double{rgb[0]} + 0.7152 * double{rgb[1]} + 0.0722 * double{rgb[2]};
    };
    double squares = 0;
    const auto error = [&](std::size_t i) {
        const double deviation = std::sqrt(std::max(0.0, double{variance[i]}));
        return deviation / std::max(kDarkest, luminance(i));
    };
    for (std::size_t i = 0; i < variance.size(); ++i) {
        squares += error(i) * error(i);
    }
    auto rgba = paint(variance.size(), [&](std::size_t i) { return heat(error(i) / kNoiseWhite); });
    const double mean =
        std::sqrt(squares / static_cast<double>(std::max<std::size_t>(1, variance.size())));
    return {std::move(rgba),
            fmt::format("Noise: the brightest pixels are off by {:.0f} % or more; the mean is "
                        "{:.1f} %.",
                        100 * kNoiseWhite, 100 * mean)};
}

}  // namespace

ViewChannel view_channel(const std::string& name) {
    if (name == "depth" || name == "object_id" || name == "material_id") {
        return {name, 1};
    }
    if (name == "normal" || name == "albedo" || name == "roughness") {
        return {name, kSamplesOfMeans};
    }
    if (name == "noise") {
        return {"variance", 0};
    }
    throw Error("the view cannot show the channel '" + name + "'");
}

ChannelPicture channel_picture(const std::string& name, const std::vector<render::Channel>& planes,
                               const render::Film& colours) {
    const std::size_t pixels = planes.at(0).values.size();
    const auto at = [&](std::size_t plane, std::size_t i) {
        return static_cast<double>(planes.at(plane).values[i]);
    };
    if (name == "depth") {
        return depth_picture(planes[0].values);
    }
    if (name == "noise") {
        return noise_picture(planes[0].values, colours);
    }
    if (name == "normal") {
        return {paint(pixels,
                      [&](std::size_t i) {
                          const Colour n{at(0, i), at(1, i), at(2, i)};
                          const bool is_seen = n[0] != 0 || n[1] != 0 || n[2] != 0;
                          return is_seen
                                     ? Colour{0.5 + 0.5 * n[0], 0.5 + 0.5 * n[1], 0.5 + 0.5 * n[2]}
                                     : Colour{};
                      }),
                "Normals in world axes: red is x, green y, blue z (up)."};
    }
    if (name == "albedo") {
        return {paint(pixels,
                      [&](std::size_t i) {
                          return Colour{pipeline::srgb_encode(at(0, i)),
                                        pipeline::srgb_encode(at(1, i)),
                                        pipeline::srgb_encode(at(2, i))};
                      }),
                "Base colours without light."};
    }
    if (name == "roughness") {
        return {paint(pixels,
                      [&](std::size_t i) {
                          return Colour{at(0, i), at(0, i), at(0, i)};
                      }),
                "Roughness of what is below the coat: black is a mirror."};
    }
    return {paint(pixels, [&](std::size_t i) { return colour_of_index(planes[0].values[i]); }),
            name == "object_id" ? "Each object has a colour of its own."
                                : "Each material has a colour of its own."};
}

}  // namespace carom::studio
