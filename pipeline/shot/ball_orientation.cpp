#include "pipeline/shot/ball_orientation.h"

#include <numbers>

#include "core/elementary.h"
#include "core/splitmix.h"

namespace carom::pipeline {

namespace {

constexpr double kDegree = std::numbers::pi / 180;

/// The FNV-1a hash (Fowler, Noll, Vo; parameters of draft-eastlake-fnv).
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

/// A random number, uniform in [low, high); `dimension` distinguishes the draws of one ball.
double draw(std::uint64_t seed, std::uint64_t name, std::uint64_t dimension, double low,
            double high) {
    const std::uint64_t bits = mix(mix(seed ^ mix(name)) + dimension);
    return low + (high - low) * unit_number(bits);
}

Quat rotation(const Vec3& unit_axis, double angle) {
    return Quat(cosine(angle / 2), unit_axis * sine(angle / 2));
}

}  // namespace

Quat initial_ball_orientation(std::uint64_t seed, std::string_view name) {
    const std::uint64_t hash = hash_name(name);
    const double azimuth = draw(seed, hash, 0, 120, 240) * kDegree;
    const double elevation = draw(seed, hash, 1, 10, 65) * kDegree;
    const double roll = draw(seed, hash, 2, -40, 40) * kDegree;
    // The ball is rotated about the disc's own axis, then in elevation, then in azimuth; the right
    // factor of a product acts first.
    const Quat orientation =
        rotation({0, 0, 1}, azimuth) * rotation({0, 1, 0}, -elevation) * rotation({1, 0, 0}, roll);
    return orientation.normalized();
}

}  // namespace carom::pipeline
