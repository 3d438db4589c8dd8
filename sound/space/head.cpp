#include "sound/space/head.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/elementary.h"

namespace carom::sound {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kSpeakerAngle = kPi / 6;

/// `theta`: between the direction of the sound and that of the ear, rad, in [0, pi].
Ear sphere_ear(double theta) {
    constexpr double kRadiusTime = kHeadRadius / kSpeedOfSound;
    // 2 f / 2 w0: a unit of the bilinear transform's s in units of the corner.
    constexpr double kWarp = kSampleRate * kRadiusTime;
    const double alpha = 1.05 + 0.95 * cosine(1.2 * theta);
    Ear ear;
    ear.delay = theta < kPi / 2 ? -kRadiusTime * cosine(theta) : kRadiusTime * (theta - kPi / 2);
    ear.b0 = (1 + alpha * kWarp) / (1 + kWarp);
    ear.b1 = (1 - alpha * kWarp) / (1 + kWarp);
    ear.a1 = (1 - kWarp) / (1 + kWarp);
    return ear;
}

Ears sphere_ears(double aside) {
    return {sphere_ear(arccosine(-aside)), sphere_ear(arccosine(aside))};
}

Ears panned_ears(double aside) {
    // From 0, all in the left loudspeaker, to pi / 2, all in the right one.
    const double angle = arcsine(aside) / kSpeakerAngle;
    const SinCos at = sin_cos(kPi / 4 * (1 + std::clamp(angle, -1.0, 1.0)));
    Ears ears;
    ears.left.b0 = std::numbers::sqrt2 * at.cos;
    ears.right.b0 = std::numbers::sqrt2 * at.sin;
    return ears;
}

}  // namespace

Vec3 direction_of(const Listener& listener, const Vec3& place) {
    const Vec3 path = place - listener.position;
    const double length = std::sqrt(path.dot(path));
    if (!(length > 0)) {
        return {0, 1, 0};
    }
    return Vec3(path.dot(listener.right), path.dot(listener.ahead), path.dot(listener.up)) / length;
}

Vec3 widened(const Vec3& direction, double half_width) {
    const double tangent_shown = tangent(half_width);
    const double most = 3;
    const double k =
        tangent_shown > 0 ? std::clamp(tangent(kSpeakerAngle) / tangent_shown, 1.0, most) : 1.0;
    const double level = direction.x * direction.x + direction.y * direction.y;
    const double aside = k * direction.x;
    const double length = std::sqrt(aside * aside + direction.y * direction.y);
    if (!(length > 0)) {
        return direction;
    }
    const double scale = std::sqrt(level) / length;
    return {scale * aside, scale * direction.y, direction.z};
}

Ears ears_of(Stereo stereo, Width width, const Listener& listener, const Vec3& place) {
    if (stereo == Stereo::mono) {
        return {};
    }
    Vec3 direction = direction_of(listener, place);
    if (width == Width::frame) {
        direction = widened(direction, listener.half_width);
    }
    const double aside = std::clamp(direction.x, -1.0, 1.0);
    return stereo == Stereo::sphere ? sphere_ears(aside) : panned_ears(aside);
}

}  // namespace carom::sound
