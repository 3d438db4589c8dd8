#include "pipeline/shot/keyed_motion.h"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "sim/timeline/hermite.h"
#include "sim/timeline/turning.h"

namespace carom::pipeline {

namespace {

using sim::Key;
using sim::Turning;

/// A key with all that was left open filled in.
struct Station {
    double time = 0;
    Vec3 position{0, 0, 0};
    Quat orientation;
    Vec3 turn{0, 0, 0};  // from the key before, rotation vector
    std::optional<Vec3> velocity;
};

std::vector<Station> filled_in(const std::vector<MotionKey>& keys, const Pose& start) {
    std::vector<Station> stations;
    Station last;
    last.position = start.position;
    last.orientation = start.orientation;
    for (const MotionKey& key : keys) {
        Station station;
        station.time = key.time;
        station.position = key.position.value_or(last.position);
        station.velocity = key.velocity;
        if (key.turn) {
            station.turn = *key.turn;
            station.orientation =
                (sim::rotation_from_vector(*key.turn) * last.orientation).normalized();
        } else {
            station.orientation = key.rotate.value_or(last.orientation).normalized();
            station.turn = sim::rotation_vector(station.orientation * ~last.orientation);
        }
        stations.push_back(station);
        last = station;
    }
    return stations;
}

/// The mean velocity from the key before to the key after (Catmull and Rom 1974), so that it has
/// no jump. Zero where a neighbour is in the same place: what pauses must not drift.
Vec3 mean_velocity(const Vec3& before, const Vec3& after, double duration) {
    const Vec3 zero(0, 0, 0);
    return before == zero || after == zero ? zero : (before + after) / duration;
}

/// Turns by more than half a round about different axes have no mean that a turn between could
/// follow.
bool can_blend(const Vec3& before, const Vec3& after) {
    const double lengths = before.length() * after.length();
    const bool are_parallel = before.cross(after).length() <= 1e-9 * lengths;
    return are_parallel ||
           (before.length() <= std::numbers::pi && after.length() <= std::numbers::pi);
}

/// Orientation in the middle of a turn and at its end, if the angular velocity goes linearly from
/// `from` to `middle` in the first half and on to `to` in the second.
struct Halves {
    Quat middle;
    Quat end;
};

Halves turned(const Quat& start, const Vec3& from, const Vec3& middle, const Vec3& to,
              double half) {
    const Turning first(from, middle, half);
    const Turning second(middle, to, half);
    Halves result;
    result.middle = first.advance(start, 0, first.substeps()).normalized();
    result.end = second.advance(result.middle, 0, second.substeps()).normalized();
    return result;
}

/// The key half-way, with the angular velocity by which the turn ends where it must.
Key middle_key(const Key& from, const Key& to, const Vec3& turn) {
    const double duration = to.time - from.time;
    const double half = duration / 2;
    const Vec3& w0 = from.angular_velocity_out;
    const Vec3& w1 = to.angular_velocity_in;
    // Exact about one axis: duration (w0 + 2 w + w1) / 4 is the turn.
    Vec3 w = turn / half - (w0 + w1) / 2;
    Halves halves = turned(from.orientation, w0, w, w1, half);
    // About changing axes by Newton's method, with differences for derivatives.
    constexpr int kMostSteps = 20;
    constexpr double kEnough = 1e-13;  // rad
    const auto rest_of = [&](const Halves& reached) {
        return sim::rotation_vector(to.orientation * ~reached.end);
    };
    const double farthest =
        4 * (turn.length() + duration * (w0.length() + w1.length()) + std::numbers::pi);
    for (int step = 0; step < kMostSteps; ++step) {
        const Vec3 rest = rest_of(halves);
        if (rest.length() <= kEnough) {
            break;
        }
        constexpr double kNudge = 1e-5;  // rad
        Imath::M33d change;              // of the end by the middle's angular velocity, row by axis
        for (int axis = 0; axis < 3; ++axis) {
            Vec3 nudged = w;
            nudged[axis] += kNudge / half;
            const Halves other = turned(from.orientation, w0, nudged, w1, half);
            const Vec3 moved = sim::rotation_vector(other.end * ~halves.end) * (half / kNudge);
            for (int i = 0; i < 3; ++i) {
                change[axis][i] = moved[i];
            }
        }
        const Vec3 better = w + rest * change.inverse();
        if (!(better.length() * duration <= farthest)) {
            break;  // what is left is spread over the turn
        }
        w = better;
        halves = turned(from.orientation, w0, w, w1, half);
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

Key key_at(const Station& station) {
    Key key;
    key.time = station.time;
    key.position = station.position;
    key.orientation = station.orientation;
    return key;
}

std::vector<Key> linear_keys(const std::vector<Station>& stations) {
    std::vector<Key> keys;
    for (const Station& station : stations) {
        keys.push_back(key_at(station));
        if (keys.size() > 1) {
            Key& before = keys[keys.size() - 2];
            const double duration = station.time - before.time;
            before.velocity_out = (station.position - before.position) / duration;
            before.angular_velocity_out = station.turn / duration;
            keys.back().velocity_in = before.velocity_out;
            keys.back().angular_velocity_in = before.angular_velocity_out;
        }
    }
    return keys;
}

std::vector<Key> smooth_keys(const std::vector<Station>& stations) {
    std::vector<Key> keys;
    for (std::size_t i = 0; i < stations.size(); ++i) {
        const Station& station = stations[i];
        Key key = key_at(station);
        if (i > 0 && i + 1 < stations.size()) {
            const Station& next = stations[i + 1];
            const Station& last = stations[i - 1];
            const double duration = next.time - last.time;
            key.velocity_in = mean_velocity(station.position - last.position,
                                            next.position - station.position, duration);
            if (can_blend(station.turn, next.turn)) {
                key.angular_velocity_in = mean_velocity(station.turn, next.turn, duration);
            }
        }
        key.velocity_in = station.velocity.value_or(key.velocity_in);
        key.velocity_out = key.velocity_in;
        key.angular_velocity_out = key.angular_velocity_in;
        if (i > 0 && station.turn != Vec3(0, 0, 0)) {
            keys.push_back(middle_key(keys.back(), key, station.turn));
        }
        keys.push_back(key);
    }
    return keys;
}

}  // namespace

sim::Track keyed_track(std::string name, const KeyedMotion& motion, const Pose& start) {
    const std::vector<Station> stations = filled_in(motion.keys, start);
    return {std::move(name), motion.is_linear ? linear_keys(stations) : smooth_keys(stations)};
}

}  // namespace carom::pipeline
