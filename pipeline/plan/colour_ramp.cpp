#include "pipeline/plan/colour_ramp.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

#include <fmt/core.h>

namespace carom::pipeline {

namespace {

using Rgb = std::array<double, 3>;

// These colours are visible on light and dark pages. Lightness varies along each ramp, so that
// readers with red-green colour blindness can distinguish them too.
constexpr std::array<Rgb, 5> kCold{
    {{58, 74, 178}, {18, 138, 178}, {40, 164, 110}, {196, 160, 32}, {206, 72, 34}}};
constexpr std::array<Rgb, 4> kWarm{{{112, 48, 150}, {184, 38, 104}, {224, 84, 48}, {236, 132, 52}}};

template <std::size_t count>
Rgb mixed(const std::array<Rgb, count>& stops, double fraction) {
    const double at = std::clamp(fraction, 0.0, 1.0) * static_cast<double>(count - 1);
    const std::size_t i = std::min(static_cast<std::size_t>(at), count - 2);
    const double part = at - static_cast<double>(i);
    Rgb result{};
    for (std::size_t c = 0; c < 3; ++c) {
        result.at(c) = (1 - part) * stops.at(i).at(c) + part * stops.at(i + 1).at(c);
    }
    return result;
}

}  // namespace

std::string ColourRamp::colour(std::size_t place) const {
    return colour_at(static_cast<double>(place) / static_cast<double>(members.size() - 1));
}

std::string ColourRamp::colour_at(double fraction) const {
    const Rgb rgb = is_warm ? mixed(kWarm, fraction) : mixed(kCold, fraction);
    return fmt::format("#{:02x}{:02x}{:02x}", std::lround(rgb[0]), std::lround(rgb[1]),
                       std::lround(rgb[2]));
}

std::vector<ColourRamp> colour_ramps(std::span<const RampEntry> entries) {
    using Appearance = std::tuple<bool, std::string, bool, int>;
    std::map<Appearance, std::size_t> ramp_of;
    std::vector<ColourRamp> ramps;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const auto& [paint, is_ball] = entries[i];
        const Appearance appearance{is_ball, paint.colour, paint.is_striped, paint.number};
        const auto [found, is_new] = ramp_of.emplace(appearance, ramps.size());
        if (is_new) {
            ramps.push_back({{}, is_ball});
        }
        ramps[found->second].members.push_back(i);
    }
    std::erase_if(ramps, [](const ColourRamp& ramp) { return ramp.members.size() < 2; });
    return ramps;
}

}  // namespace carom::pipeline
