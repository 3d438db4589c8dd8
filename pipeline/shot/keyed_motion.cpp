#include "pipeline/shot/keyed_motion.h"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "sim/timeline/hermite.h"
#include "sim/timeline/rotation_segment.h"

namespace carom::pipeline {

namespace {

using sim::Key;
using sim::RotationSegment;

/// A motion key with the values of the previous key where it has none of its own.
struct ResolvedKey {
    double time = 0;
    Vec3 position{0, 0, 0};
    Quat orientation;
    Vec3 turn{0, 0, 0};  // since the previous key, rotation vector
    std::optional<Vec3> velocity;
};

std::vector<ResolvedKey> resolve_keys(const std::vector<MotionKey>& keys, const Pose& start) {
    std::vector<ResolvedKey> resolved;
    ResolvedKey last;
    last.position = start.position;
    last.orientation = start.orientation;
    for (const MotionKey& key : keys) {
        ResolvedKey current;
        current.time = key.time;
        current.position = key.position.value_or(last.position);
        current.velocity = key.velocity;
        if (key.turn) {
            current.turn = *key.turn;
            current.orientation =
                (sim::rotation_from_vector(*key.turn) * last.orientation).normalized();
        } else {
            current.orientation = key.rotate.value_or(last.orientation).normalized();
            current.turn = sim::rotation_vector(current.orientation * ~last.orientation);
        }
        resolved.push_back(current);
        last = current;
    }
    return resolved;
}

/// The mean velocity from the previous key to the next (Catmull and Rom 1974), so that the velocity
/// is continuous. It is zero if a neighbour has the same position, so that an object does not drift
/// during a pause.
Vec3 mean_velocity(const Vec3& before, const Vec3& after, double duration) {
    const Vec3 zero(0, 0, 0);
    return before == zero || after == zero ? zero : (before + after) / duration;
}

/// Whether the mean of two rotations is a useful angular velocity between them. It is not for
/// rotations by more than half a revolution about different axes.
bool can_blend(const Vec3& before, const Vec3& after) {
    const double lengths = before.length() * after.length();
    const bool are_parallel = before.cross(after).length() <= 1e-9 * lengths;
    return are_parallel ||
           (before.length() <= std::numbers::pi && after.length() <= std::numbers::pi);
}

/// Orientations in the middle and at the end of a rotation whose angular velocity changes linearly,
/// from `from` to `middle` in the first half and then to `to` in the second.
struct HalfwayAndEnd {
    Quat middle;
    Quat end;
};

HalfwayAndEnd integrate_rotation(const Quat& start, const Vec3& from, const Vec3& middle,
                                 const Vec3& to, double half) {
    const RotationSegment first(from, middle, half);
    const RotationSegment second(middle, to, half);
    HalfwayAndEnd result;
    result.middle = first.advance(start, 0, first.substeps()).normalized();
    result.end = second.advance(result.middle, 0, second.substeps()).normalized();
    return result;
}

/// The key halfway between two keys, with the angular velocity for which the rotation ends at the
/// orientation of `to`.
Key make_middle_key(const Key& from, const Key& to, const Vec3& turn) {
    const double duration = to.time - from.time;
    const double half = duration / 2;
    const Vec3& w0 = from.angular_velocity_out;
    const Vec3& w1 = to.angular_velocity_in;
    // For rotations about one axis this is exact: the angle is duration (w0 + 2 w + w1) / 4.
    Vec3 w = turn / half - (w0 + w1) / 2;
    HalfwayAndEnd halves = integrate_rotation(from.orientation, w0, w, w1, half);
    // For changing axes, Newton's method with finite differences as derivatives.
    constexpr int kMaxSteps = 20;
    constexpr double kTolerance = 1e-13;  // rad
    const auto error_of = [&](const HalfwayAndEnd& result) {
        return sim::rotation_vector(to.orientation * ~result.end);
    };
    const double largest_angle =
        4 * (turn.length() + duration * (w0.length() + w1.length()) + std::numbers::pi);
    for (int step = 0; step < kMaxSteps; ++step) {
        const Vec3 error = error_of(halves);
        if (error.length() <= kTolerance) {
            break;
        }
        constexpr double kDifference = 1e-5;  // rad
        Imath::M33d jacobian;  // of the end by the middle's angular velocity, one row per axis
        for (int axis = 0; axis < 3; ++axis) {
            Vec3 shifted = w;
            shifted[axis] += kDifference / half;
            const HalfwayAndEnd other = integrate_rotation(from.orientation, w0, shifted, w1, half);
            const Vec3 moved = sim::rotation_vector(other.end * ~halves.end) * (half / kDifference);
            for (int i = 0; i < 3; ++i) {
                jacobian[axis][i] = moved[i];
            }
        }
        const Vec3 improved = w + error * jacobian.inverse();
        if (!(improved.length() * duration <= largest_angle)) {
            break;  // the track distributes the remaining error over the rotation
        }
        w = improved;
        halves = integrate_rotation(from.orientation, w0, w, w1, half);
    }
    const sim::PathSegment path{from.time,   to.time,           from.position,
                                to.position, from.velocity_out, to.velocity_in};
    Key key;
    key.time = from.time + half;
    key.position = sim::hermite_position(path, key.time);
    key.orientation = halves.middle;
    key.velocity_in = key.velocity_out = sim::hermite_velocity(path, key.time);
    key.angular_velocity_in = key.angular_velocity_out = w;
    return key;
}

Key key_at(const ResolvedKey& current) {
    Key key;
    key.time = current.time;
    key.position = current.position;
    key.orientation = current.orientation;
    return key;
}

std::vector<Key> linear_keys(const std::vector<ResolvedKey>& resolved) {
    std::vector<Key> keys;
    for (const ResolvedKey& current : resolved) {
        keys.push_back(key_at(current));
        if (keys.size() > 1) {
            Key& before = keys[keys.size() - 2];
            const double duration = current.time - before.time;
            before.velocity_out = (current.position - before.position) / duration;
            before.angular_velocity_out = current.turn / duration;
            keys.back().velocity_in = before.velocity_out;
            keys.back().angular_velocity_in = before.angular_velocity_out;
        }
    }
    return keys;
}

std::vector<Key> smooth_keys(const std::vector<ResolvedKey>& resolved) {
    std::vector<Key> keys;
    for (std::size_t i = 0; i < resolved.size(); ++i) {
        const ResolvedKey& current = resolved[i];
        Key key = key_at(current);
        if (i > 0 && i + 1 < resolved.size()) {
            const ResolvedKey& next = resolved[i + 1];
            const ResolvedKey& last = resolved[i - 1];
            const double duration = next.time - last.time;
            key.velocity_in = mean_velocity(current.position - last.position,
                                            next.position - current.position, duration);
            if (can_blend(current.turn, next.turn)) {
                key.angular_velocity_in = mean_velocity(current.turn, next.turn, duration);
            }
        }
        key.velocity_in = current.velocity.value_or(key.velocity_in);
        key.velocity_out = key.velocity_in;
        key.angular_velocity_out = key.angular_velocity_in;
        if (i > 0 && current.turn != Vec3(0, 0, 0)) {
            keys.push_back(make_middle_key(keys.back(), key, current.turn));
        }
        keys.push_back(key);
    }
    return keys;
}

}  // namespace

sim::Track keyed_track(std::string name, const KeyedMotion& motion, const Pose& start) {
    const std::vector<ResolvedKey> resolved = resolve_keys(motion.keys, start);
    return {std::move(name), motion.is_linear ? linear_keys(resolved) : smooth_keys(resolved)};
}

}  // namespace carom::pipeline
