#include "pipeline/shot/ball_orientation.h"

#include <cmath>
#include <numbers>

#include "core/splitmix.h"

namespace carom::pipeline {

namespace {

constexpr double kDegree = std::numbers::pi / 180;

/// FNV-1a (Fowler, Noll, Vo; parameters of draft-eastlake-fnv).
std::uint64_t hash_name(std::string_view name) {
    std::uint64_t hash = 0xCBF29CE484222325U;
    for (const char c : name) {
        hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3U;
    }
    return hash;
}

std::uint64_t mix(std::uint64_t z) {
    return split_mix(z + kSplitMixStep);
}

/// Uniform in [low, high); `dimension` tells the draws of one ball apart.
double draw(std::uint64_t seed, std::uint64_t name, std::uint64_t dimension, double low,
            double high) {
    const std::uint64_t bits = mix(mix(seed ^ mix(name)) + dimension);
    return low + (high - low) * unit_number(bits);
}

Quat turn(const Vec3& unit_axis, double angle) {
    return Quat(std::cos(angle / 2), unit_axis * std::sin(angle / 2));
}

}  // namespace

Quat initial_ball_orientation(std::uint64_t seed, std::string_view name) {
    const std::uint64_t hash = hash_name(name);
    const double azimuth = draw(seed, hash, 0, 120, 240) * kDegree;
    const double elevation = draw(seed, hash, 1, 10, 65) * kDegree;
    const double roll = draw(seed, hash, 2, -40, 40) * kDegree;
    // Roll about the disc's own axis, then lift it, then turn it to its side; the right factor of
    // a product acts first.
    const Quat orientation =
        turn({0, 0, 1}, azimuth) * turn({0, 1, 0}, -elevation) * turn({1, 0, 0}, roll);
    return orientation.normalized();
}

}  // namespace carom::pipeline
