#include "pipeline/camera/shake.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/elementary.h"
#include "core/splitmix.h"
#include "pipeline/camera/steady_up.h"
#include "pipeline/camera/view_axes.h"

namespace carom::pipeline {

namespace {

constexpr int kSines = 12;
constexpr double kLowest = -1;   // octaves from the main frequency
constexpr double kOctaves = 3;   // up to four times the main frequency
constexpr double kLever = 0.35;  // m
constexpr double kRollShare = 0.5;

/// Noise with the root mean square 1 at `time`. `random` gives its frequencies and phases.
double noise(SplitMix64& random, double frequency, double time) {
    double sum = 0;
    double square = 0;  // the mean square of the sum
    for (int i = 0; i < kSines; ++i) {
        const double ratio = exponential2(kLowest + kOctaves * (i + random.next_unit()) / kSines);
        const double turns = ratio * frequency * time + random.next_unit();
        const double amplitude = 1 / ratio;
        sum += amplitude * sine(2 * std::numbers::pi * (turns - std::floor(turns)));
        square += amplitude * amplitude / 2;
    }
    return sum / std::sqrt(square);
}

/// The up direction of a camera whose view the hand moves. If the view is nearly along `up`, a
/// small turn of the view would let the picture spin about it. There the camera's own upright
/// direction takes its place, so that the hand turns the whole camera.
Vec3 held_up(const render::CameraState& camera, const Vec3& ahead, const Shake& shake) {
    constexpr double kMostNear = std::numbers::pi / 60;  // rad
    const double near = std::min(10 * shake.strength, kMostNear);
    const Vec3 up = camera.up.normalized();
    const double sine = ahead.cross(up).length();
    if (!(sine < 2 * near)) {
        return camera.up;
    }
    const double x = std::clamp(sine / near - 1, 0.0, 1.0);
    const double weight = x * x * (3 - 2 * x);
    return (1 - weight) * upright_of(ahead, up) + weight * up;
}

}  // namespace

ShakeOffset shake_at(const Shake& shake, double time) {
    SplitMix64 random(split_mix(shake.seed));
    const auto next = [&](double size) { return size * noise(random, shake.frequency, time); };
    ShakeOffset offset;
    offset.pan = next(shake.strength);
    offset.tilt = next(shake.strength);
    offset.roll = next(kRollShare * shake.strength);
    for (int i = 0; i < 3; ++i) {
        offset.shift[i] = next(kLever * shake.strength);
    }
    return offset;
}

render::CameraState shaken(const render::CameraState& camera, const Shake& shake, double time) {
    const ShakeOffset offset = shake_at(shake, time);
    const ViewAxes axes = view_axes(camera);
    const SinCos pan = sin_cos(offset.pan);
    const SinCos tilt = sin_cos(offset.tilt);
    const Vec3 ahead =
        tilt.cos * (pan.cos * axes.ahead + pan.sin * axes.right) + tilt.sin * axes.up;
    render::CameraState result = camera;
    result.position +=
        offset.shift.x * axes.right + offset.shift.y * axes.up + offset.shift.z * axes.ahead;
    result.target = result.position + (camera.target - camera.position).length() * ahead;
    result.up = held_up(camera, axes.ahead, shake);
    result.roll += offset.roll;
    return result;
}

}  // namespace carom::pipeline
