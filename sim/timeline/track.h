// The motion of one object: keys and the curve between them (formulas: docs/timeline.md).
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/pose.h"

namespace carom::sim {

/// The state at one instant. It has one pose, but incoming and outgoing velocities, which differ at
/// an instantaneous change (an impact, a strike).
struct Key {
    double time = 0;  // scene time, s
    Vec3 position{0, 0, 0};
    Quat orientation{};
    Vec3 velocity_in{0, 0, 0};
    Vec3 angular_velocity_in{0, 0, 0};
    Vec3 velocity_out{0, 0, 0};
    Vec3 angular_velocity_out{0, 0, 0};

    [[nodiscard]] bool is_break() const {
        return velocity_in != velocity_out || angular_velocity_in != angular_velocity_out;
    }
    bool operator==(const Key&) const = default;
};

/// One smooth piece of a path: the cubic Hermite curve from (p0, v0) at `start` to (p1, v1) at
/// `end`.
struct PathSegment {
    double start = 0;  // scene time, s
    double end = 0;
    Vec3 p0, p1;
    Vec3 v0, v1;  // m/s
};

struct Bounds {
    Vec3 low, high;
};

/// The time of the key with which a jump at `time` ends: the next number after it.
[[nodiscard]] double time_after_jump(double time);

/// Immutable; copies share their keys, so a copy costs as little as a pointer. Positions follow the
/// cubic Hermite curve through positions and velocities. Where an object is put somewhere else, the
/// track jumps: two keys are a number apart (time_after_jump) and their positions are not. No
/// instant lies between them, and nothing interpolates them. The angular velocity is linear between
/// one key's outgoing and the next one's incoming value. The orientation is its fourth-order Magnus
/// integral in substeps of at most 0.5 rad, with the residual at the next key distributed linearly,
/// so that turns of more than 180 degrees between keys are kept.
class Track {
  public:
    /// Requires at least one key, strictly increasing times, finite values, unit quaternions within
    /// 1e-6 and a total of at most 1e6 rad of rotation about changing axes. Otherwise throws an
    /// Error that names the track and the key.
    Track(std::string name, std::vector<Key> keys);

    [[nodiscard]] const std::string& name() const { return data_->name; }
    [[nodiscard]] std::span<const Key> keys() const { return data_->keys; }

    /// Whether the object jumps from key `index` to the next one.
    [[nodiscard]] bool jumps_after(std::size_t index) const;

    /// Defined for every time: before the first and after the last key the object rests in the pose
    /// of that key. At the instant of a break the outgoing velocities are returned, at that of a
    /// jump the state after it.
    [[nodiscard]] MotionState sample(double scene_time) const;

    /// The smooth segments of [from, to] (from <= to), cut at its ends, in order of time and
    /// without gaps. Outside of the keys the segments are constant. At least one segment, even if
    /// from == to. At a jump the next segment begins elsewhere, a number after the previous one's
    /// end.
    [[nodiscard]] std::vector<PathSegment> segments(double from, double to) const;

    /// A box that contains all positions during [from, to].
    [[nodiscard]] Bounds position_bounds(double from, double to) const;

    bool operator==(const Track& other) const {
        return data_ == other.data_ ||
               (data_->name == other.data_->name && data_->keys == other.data_->keys);
    }

  private:
    // Data of the rotation from one key to the next, for sample().
    struct KeyInterval {
        Vec3 residual{0, 0, 0};            // rotation vector that remains at the next key
        std::size_t first_checkpoint = 0;  // orientation at every 16th substep
    };

    // A segment between two keys and the required part of it.
    struct Piece {
        PathSegment segment;
        double from = 0;
        double to = 0;
    };

    struct Data {
        std::string name;
        std::vector<Key> keys;
        std::vector<double> times;  // of the keys, contiguous for the binary search
        std::vector<KeyInterval> intervals;
        std::vector<Quat> checkpoints;
        std::vector<std::size_t> jumps;  // keys after which it jumps, increasing
    };

    [[nodiscard]] static Data prepare(std::string name, std::vector<Key> keys);
    [[nodiscard]] std::size_t last_key_at(double scene_time) const;
    [[nodiscard]] PathSegment segment_after(std::size_t index) const;
    [[nodiscard]] std::vector<Piece> pieces(double from, double to) const;
    [[nodiscard]] Quat orientation_in(std::size_t index, double scene_time) const;

    std::shared_ptr<const Data> data_;
};

}  // namespace carom::sim
