// Functions that build keys and tracks, and random numbers, for the tests of timelines.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/splitmix.h"
#include "sim/timeline/track.h"

namespace carom::sim::test {

class RandomNumbers {
  public:
    explicit RandomNumbers(std::uint64_t seed) : random_(seed << 32) {}

    /// In [0, 1).
    double unit() { return random_.next_unit(); }
    /// One of 0 ... count - 1.
    std::size_t below(std::size_t count) {
        return static_cast<std::size_t>(unit() * static_cast<double>(count));
    }
    double between(double low, double high) { return low + (high - low) * unit(); }
    Vec3 vector(double size) {
        const double x = between(-size, size);
        const double y = between(-size, size);
        const double z = between(-size, size);
        return {x, y, z};
    }
    Quat rotation() {
        const double w = between(-1, 1);
        return Quat(w, vector(1)).normalized();
    }

  private:
    SplitMix64 random_;
};

/// A key with equal incoming and outgoing velocities.
inline Key smooth_key(double time, const Vec3& position, const Vec3& velocity,
                      const Quat& orientation = {}, const Vec3& angular_velocity = {0, 0, 0}) {
    return {time, position, orientation, velocity, angular_velocity, velocity, angular_velocity};
}

inline Key random_key(RandomNumbers& numbers, double time, bool is_break) {
    // In separate statements, since the evaluation order of a call's arguments is unspecified.
    Key key;
    key.time = time;
    key.position = numbers.vector(1);
    key.orientation = numbers.rotation();
    key.velocity_in = key.velocity_out = numbers.vector(3);
    key.angular_velocity_in = key.angular_velocity_out = numbers.vector(20);
    if (is_break) {
        key.velocity_out = numbers.vector(3);
        key.angular_velocity_out = numbers.vector(20);
    }
    return key;
}

/// A track with keys at irregular times from `start` on, about every third of them a break.
inline Track random_track(std::uint64_t seed, int key_count, double start = 0.25) {
    RandomNumbers numbers(seed);
    std::vector<Key> keys;
    double time = start;
    for (int index = 0; index < key_count; ++index) {
        const bool is_break = numbers.unit() < 0.3;
        keys.push_back(random_key(numbers, time, is_break));
        time += numbers.between(0.001, 0.4);
    }
    return Track("ball", keys);
}

}  // namespace carom::sim::test
