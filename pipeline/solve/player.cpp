#include "pipeline/solve/player.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/elementary.h"
#include "core/length.h"
#include "core/normal.h"
#include "core/splitmix.h"
#include "sim/stick/strike.h"

namespace carom::pipeline::solve {
namespace {

constexpr double kMaxElevation = 85 * std::numbers::pi / 180;

double normal_number(SplitMix64& random) {
    return normal_quantile(random.next_unit() + 0x1p-54);
}

Vec2 normal_pair(SplitMix64& random) {
    const double first = normal_number(random);
    return {first, normal_number(random)};
}

}  // namespace

std::optional<PlayerError> player_error(std::string_view level) {
    constexpr double kDegree = std::numbers::pi / 180;
    const double factor = level == "professional" ? 0.5
                          : level == "club"       ? 1
                          : level == "beginner"   ? 3
                                                  : 0;
    if (factor == 0) {
        return std::nullopt;
    }
    constexpr double kTip = 0.0005 / 0.0286;
    return PlayerError{factor * 0.125 * kDegree, factor * 0.1 * kDegree, factor * 0.04,
                       factor * kTip};
}

Setting disturbed(const Setting& setting, const PlayerError& error, std::uint64_t number) {
    SplitMix64 random(split_mix(number + 1));
    const Vec2 first = normal_pair(random);
    const Vec2 second = normal_pair(random);
    const Vec2 third = normal_pair(random);
    Setting result = setting;
    result.direction += error.direction * first.x;
    result.speed = std::max(setting.speed * (1 + error.speed * first.y), 0.01);
    result.tip += second * error.tip;
    const double offset = std::sqrt(result.tip.dot(result.tip));
    if (offset > sim::kMiscueOffset) {
        result.tip *= sim::kMiscueOffset / offset;
    }
    result.elevation = std::clamp(setting.elevation + error.elevation * third.x, 0.0,
                                  std::max(kMaxElevation, setting.elevation));
    return result;
}

Setting rounded(const Setting& setting) {
    constexpr double kDegree = std::numbers::pi / 180;
    const auto to = [](double value, double parts) {
        return static_cast<double>(std::llround(value * parts)) / parts;
    };
    Setting result;
    const double turns = std::floor(setting.direction / (2 * std::numbers::pi));
    result.direction = to((setting.direction / kDegree) - 360 * turns, 1e6) * kDegree;
    result.speed = to(setting.speed, 1e4);
    result.tip = Vec2(to(setting.tip.x, 1e4), to(setting.tip.y, 1e4));
    result.elevation = to(setting.elevation / kDegree, 1e6) * kDegree;
    return result;
}

double squirt_of(const sim::Strike& strike, const Setting& setting, double radius) {
    Setting along_x = setting;
    along_x.direction = 0;
    const Vec3 direction =
        sim::tip_contact(with_setting(strike, along_x), Vec3(1, 0, 0), radius).direction;
    return arctangent2(direction.y, direction.x);
}

Setting setting_of(const sim::Strike& strike) {
    Setting setting;
    setting.direction = strike.direction.value_or(0);
    setting.speed = strike.speed.value_or(strike.ball_speed.value_or(setting.speed));
    setting.tip = strike.tip;
    setting.elevation = strike.elevation;
    return setting;
}

sim::Strike with_setting(sim::Strike strike, const Setting& setting) {
    strike.toward.reset();
    strike.toward_point.reset();
    strike.direction = setting.direction;
    (strike.ball_speed ? strike.ball_speed : strike.speed) = setting.speed;
    strike.tip = setting.tip;
    strike.elevation = setting.elevation;
    return strike;
}

}  // namespace carom::pipeline::solve
