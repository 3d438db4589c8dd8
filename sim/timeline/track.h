// One object's motion: keys, and the curve between them (docs/timeline.md has the formulas).
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/pose.h"

namespace carom::sim {

/// The state at one instant. The pose is one; the velocities have a value on arriving and one on
/// leaving, which differ where something happened in an instant (an impact, a strike).
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

/// Immutable; copies share their keys, so a copy costs as little as a pointer. Positions follow the
/// cubic Hermite curve through positions and velocities. Orientation: the angular velocity is
/// linear between one key's outgoing and the next one's incoming value, the orientation its
/// fourth-order Magnus integral in substeps of at most 0.5 rad, the residual to the next key spread
/// linearly, so that turns beyond 180 degrees between keys survive.
class Track {
  public:
    /// Keys in strictly increasing time, all values finite, quaternions of unit length within
    /// 1e-6, at least one key, no more than 1e6 rad of turning about changing axes in all; throws
    /// Error otherwise, naming track and key.
    Track(std::string name, std::vector<Key> keys);

    [[nodiscard]] const std::string& name() const { return data_->name; }
    [[nodiscard]] std::span<const Key> keys() const { return data_->keys; }

    /// Defined for every time: before the first and after the last key the end pose holds, with
    /// zero velocities. At the very instant of a break the outgoing velocities are returned.
    [[nodiscard]] MotionState sample(double scene_time) const;

    /// The smooth pieces that make up [from, to] (from <= to), cut at its ends, in order of time,
    /// without gaps. Where the object rests or the times lie outside the keys, a constant piece.
    /// At least one piece, also when from == to.
    [[nodiscard]] std::vector<PathSegment> segments(double from, double to) const;

    /// A box around every position taken during [from, to].
    [[nodiscard]] Bounds position_bounds(double from, double to) const;

    bool operator==(const Track& other) const {
        return data_ == other.data_ ||
               (data_->name == other.data_->name && data_->keys == other.data_->keys);
    }

  private:
    // What sample() needs to know about the turn from one key to the next.
    struct KeyInterval {
        Vec3 residual{0, 0, 0};            // rotation vector left over at the next key
        std::size_t first_checkpoint = 0;  // orientation at every 16th substep
    };

    // A whole segment between keys and the part of it that is meant.
    struct Piece {
        PathSegment segment;
        double from = 0;
        double to = 0;
    };

    struct Data {
        std::string name;
        std::vector<Key> keys;
        std::vector<double> times;  // of the keys, close together for the search
        std::vector<KeyInterval> intervals;
        std::vector<Quat> checkpoints;
    };

    [[nodiscard]] static Data prepare(std::string name, std::vector<Key> keys);
    [[nodiscard]] std::size_t last_key_at(double scene_time) const;
    [[nodiscard]] PathSegment segment_after(std::size_t index) const;
    [[nodiscard]] std::vector<Piece> pieces(double from, double to) const;
    [[nodiscard]] Quat orientation_in(std::size_t index, double scene_time) const;

    std::shared_ptr<const Data> data_;
};

}  // namespace carom::sim
