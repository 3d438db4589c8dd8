#include "sound/source/direct_sound.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "sound/source/mode_sound.h"

namespace carom::sound {
namespace {

constexpr double kMaxModes = 100e3;  // Hz, nothing above is looked at for peaks

SphereWave sphere_wave(const SphereSource& sphere, const Vec3& place, double contact_distance) {
    const Vec3 path = place - sphere.centre;
    const double speed = sphere.velocity_step.length();
    const double real_distance = path.length();
    const double distance = std::max({real_distance, sphere.radius, kNearest});
    const double cosine = speed > 0 && real_distance > 0
                              ? path.dot(sphere.velocity_step) / (speed * real_distance)
                              : 0;
    const SpherePole wave = sphere_pole(sphere.radius, distance, cosine);
    return {(distance - sphere.radius - contact_distance) / kSpeedOfSound,
            {wave.pole, (speed * sphere.factor) * wave.residue}};
}

struct Grid {
    double first = 0;
    double step = 0;
    std::size_t count = 0;
};

/// The times among which the highest pressure is: from the first onset until half a period of the
/// lowest mode after the force.
Grid search_grid(const DirectSound& sound) {
    double first = 0;
    double last = 0;
    double lowest = kMaxModes;
    double highest = 0;
    const auto include = [&](const Partial& partial) {
        const double frequency = partial.pole.im / (2 * std::numbers::pi);
        lowest = std::min(lowest, frequency);
        highest = std::max(highest, std::min(frequency, kMaxModes));
    };
    for (const SphereWave& wave : sound.spheres) {
        first = std::min(first, wave.onset);
        last = std::max(last, wave.onset);
        include(wave.partial);
    }
    std::ranges::for_each(sound.modes, include);
    const double step = std::min(sound.contact_time / 48, highest > 0 ? 1 / (16 * highest) : 1.0);
    const double length = last - first + sound.contact_time + 0.5 / lowest;
    return {first, step, static_cast<std::size_t>(std::min(length / step, 1e5)) + 2};
}

}  // namespace

SpherePole sphere_pole(double radius, double distance, double cosine) {
    const double kappa = kSpeedOfSound / radius;
    const double near = radius / distance;
    const Complex pole{-kappa, kappa};
    // The numerator at the pole over the distance of the two poles, 2 i kappa.
    const Complex residue = (pole + Complex{kappa * near, 0}) / Complex{0, 2 * kappa};
    return {pole, kAirDensity * kSpeedOfSound * near * cosine * residue};
}

std::vector<SphereWave> spheres_at(const Vec3& place, const ImpactSound& sound,
                                   double contact_distance) {
    std::vector<SphereWave> waves;
    waves.reserve(sound.spheres.size());
    for (const SphereSource& sphere : sound.spheres) {
        waves.push_back(sphere_wave(sphere, place, contact_distance));
    }
    return waves;
}

DirectSound direct_sound_at(const Vec3& place, const ImpactSound& sound) {
    DirectSound direct;
    direct.distance = std::max((place - sound.place).length(), kNearest);
    direct.contact_time = sound.contact_time;
    direct.shape = sound.shape;
    direct.spheres = spheres_at(place, sound, direct.distance);
    for (const Mode& mode : sound.modes) {
        direct.modes.push_back(
            {mode_pole(mode), (sound.impulse / direct.distance) * mode_residue(mode)});
    }
    return direct;
}

Vec3 average_place(const ImpactSound& sound) {
    Vec3 axis = sound.spheres.empty() ? Vec3(0, 0, 0) : sound.spheres.front().velocity_step;
    axis = axis.length() > 0 ? axis.normalized() : Vec3(0, 0, 1);
    const Vec3 up = std::abs(axis.z) < 0.9 ? Vec3(0, 0, 1) : Vec3(0, 1, 0);
    const Vec3 across = (up - axis * up.dot(axis)).normalized();
    const Vec3 outwards = axis.z < 0 ? -axis : axis;
    return sound.place + outwards * std::sqrt(1.0 / 3) + across * std::sqrt(2.0 / 3);
}

Peak find_peak(const DirectSound& sound) {
    const Grid grid = search_grid(sound);
    std::vector<double> pressures(grid.count, 0.0);
    // Nothing ends early: half a period of the lowest mode is shorter than any ring.
    for (const SphereWave& wave : sound.spheres) {
        ModeBank(sound.contact_time, std::span(&wave.partial, 1), 0, sound.shape)
            .add(grid.first - wave.onset, grid.step, pressures);
    }
    ModeBank(sound.contact_time, sound.modes, 0, sound.shape).add(grid.first, grid.step, pressures);
    std::size_t best = 0;
    for (std::size_t i = 1; i < pressures.size(); ++i) {
        if (std::abs(pressures[i]) > std::abs(pressures[best])) {
            best = i;
        }
    }
    Peak peak{std::abs(pressures[best]), grid.first + static_cast<double>(best) * grid.step};
    if (best > 0 && best + 1 < pressures.size()) {
        const double sign = pressures[best] < 0 ? -1 : 1;
        const double before = sign * pressures[best - 1];
        const double after = sign * pressures[best + 1];
        const double bend = before - 2 * peak.pressure + after;
        if (bend < 0) {
            const double shift = 0.5 * (before - after) / bend;
            peak.pressure -= 0.25 * (before - after) * shift;
            peak.time += shift * grid.step;
        }
    }
    return peak;
}

}  // namespace carom::sound
