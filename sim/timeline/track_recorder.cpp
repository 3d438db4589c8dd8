#include "sim/timeline/track_recorder.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include <fmt/core.h>

#include "core/assert.h"
#include "core/error.h"
#include "sim/timeline/hermite.h"
#include "sim/timeline/rotation_segment.h"

namespace carom::sim {

namespace {

constexpr double kSame = 1e-9;  // absolute below one, relative above

/// Breaks below this speed (m/s) can form a train; balls that touch part at 5e-5 m/s.
constexpr double kTinyJump = 4e-4;
/// Metres by which angular velocities count as speeds: about the radius of a ball.
constexpr double kSpinRadius = 0.03;
constexpr double kTrainInterval = 1e-3;  // s

/// Keys are no further apart than this number of states, 4 s of steps.
constexpr std::size_t kMaxSkipped = 4096;

bool is_same(const Vec3& a, const Vec3& b) {
    const double size = std::max(1.0, std::max(a.length(), b.length()));
    return (a - b).length() <= kSame * size;
}

bool is_same(const Quat& a, const Quat& b) {
    return angle_between(a, b) <= kSame;
}

Key smooth_key(double time, const MotionState& state) {
    return {time,
            state.position,
            state.orientation,
            state.velocity,
            state.angular_velocity,
            state.velocity,
            state.angular_velocity};
}

PathSegment segment_between(const Key& from, const Key& to) {
    return {from.time, to.time, from.position, to.position, from.velocity_out, to.velocity_in};
}

/// Checks whether the keys between the first and the last can be dropped.
class SpanCheck {
  public:
    SpanCheck(std::span<const Key> keys, const KeyReduction& reduction)
        : keys_(keys), reduction_(reduction) {}

    [[nodiscard]] bool passes() const { return positions_pass() && orientations_pass(); }

  private:
    // Compares positions at the inner keys and midway between keys, where the dense path is curved.
    [[nodiscard]] bool positions_pass() const {
        const PathSegment span = segment_between(keys_.front(), keys_.back());
        const double bound2 = reduction_.position_error * reduction_.position_error;
        const auto is_near = [&](const Vec3& position, double time) {
            const Vec3 error = hermite_position(span, time) - position;
            return error.dot(error) <= bound2;
        };
        for (std::size_t index = 1; index < keys_.size(); ++index) {
            const PathSegment piece = segment_between(keys_[index - 1], keys_[index]);
            const double middle = 0.5 * (piece.start + piece.end);
            if (!is_near(piece.p1, piece.end) ||
                !is_near(hermite_position(piece, middle), middle)) {
                return false;
            }
        }
        return true;
    }

    // Integrates the rotation twice: first for its residual at the end, then with the residual
    // distributed.
    [[nodiscard]] bool orientations_pass() const {
        const Key& from = keys_.front();
        const Key& to = keys_.back();
        const double duration = to.time - from.time;
        const RotationSegment rotation(from.angular_velocity_out, to.angular_velocity_in, duration);
        const Vec3 residual = rotation_vector(
            to.orientation * ~rotation.advance(from.orientation, 0, rotation.substeps()));
        std::uint32_t substep = 0;
        Quat at_substep = from.orientation;
        for (const Key& key : keys_.subspan(1, keys_.size() - 2)) {
            const double elapsed = key.time - from.time;
            const std::uint32_t next = rotation.substep_at(elapsed);
            at_substep = rotation.advance(at_substep, substep, next);
            substep = next;
            const Quat turned = rotation.finish(at_substep, substep, elapsed);
            const Quat orientation = rotation_from_vector(elapsed / duration * residual) * turned;
            if (!(angle_between(orientation, key.orientation) <= reduction_.orientation_error)) {
                return false;
            }
        }
        return true;
    }

    std::span<const Key> keys_;
    const KeyReduction& reduction_;
};

}  // namespace

TrackRecorder::TrackRecorder(std::string name, KeyReduction reduction)
    : name_(std::move(name)), reduction_(reduction) {
    CAROM_ASSERT(reduction.position_error > 0 && reduction.orientation_error > 0);
}

void TrackRecorder::add_key(const Key& key, bool is_kept) {
    if (!dense_.empty() && !(key.time > dense_.back().time)) {
        throw Error(fmt::format("track '{}': a state at {:f} s was added after one at {:f} s",
                                name_, key.time, dense_.back().time));
    }
    dense_.push_back(key);
    if (is_kept || dense_.size() == 1) {
        keep_last();
    }
    // The last state may still be changed.
    reduce(1);
}

bool TrackRecorder::is_last_kept() const {
    return dense_.size() == 1 || (!kept_.empty() && kept_.back() == dense_.size() - 1);
}

void TrackRecorder::keep_last() {
    kept_time_ = dense_.back().time;
    if (dense_.size() > 1) {
        kept_.push_back(dense_.size() - 1);
    }
}

bool TrackRecorder::can_skip(std::size_t step) const {
    return step <= 1 || SpanCheck(std::span(dense_).first(step + 1), reduction_).passes();
}

/// Makes keys of all states but the last `open` ones, which may still change, as far as they decide
/// which ones. From each key the largest step that passes is found by doubling and bisection; for n
/// states this evaluates O(n log n).
void TrackRecorder::reduce(std::size_t open) {
    for (;;) {
        const std::size_t longest =
            kept_.empty() ? kMaxSkipped : std::min(kept_.front(), kMaxSkipped);
        const std::size_t step = std::min(2 * good_, longest);
        if (step + open >= dense_.size()) {
            return;
        }
        if (good_ < longest && can_skip(step)) {
            good_ = step;
            continue;
        }
        std::size_t bad = good_ < longest ? step : good_ + 1;
        while (bad - good_ > 1) {
            const std::size_t middle = good_ + (bad - good_) / 2;
            (can_skip(middle) ? good_ : bad) = middle;
        }
        advance(good_);
    }
}

void TrackRecorder::advance(std::size_t step) {
    if (keys_.empty()) {
        keys_.push_back(dense_.front());
    }
    keys_.push_back(dense_[step]);
    dense_.erase(dense_.begin(), dense_.begin() + static_cast<std::ptrdiff_t>(step));
    if (!kept_.empty() && kept_.front() == step) {
        kept_.pop_front();
    }
    for (std::size_t& index : kept_) {
        index -= step;
    }
    good_ = 1;
}

/// Whether a break need not be kept: it is one of a train, and a kept key is near. The ends of
/// motion segments between the breaks of a train, which have no jump, belong to it; coming to rest
/// does not.
bool TrackRecorder::is_in_train(double time, const MotionState& before, const MotionState& after) {
    const double jump = (after.velocity - before.velocity).length() +
                        kSpinRadius * (after.angular_velocity - before.angular_velocity).length();
    if (after.velocity == Vec3(0, 0, 0) && after.angular_velocity == Vec3(0, 0, 0)) {
        return was_tiny_ = false;
    }
    was_tiny_ = jump <= kTinyJump && (jump > 0 || was_tiny_);
    return was_tiny_ && !dense_.empty() && time - kept_time_ < kTrainInterval;
}

void TrackRecorder::add(double time, const MotionState& state) {
    if (dense_.empty() || dense_.back().time != time) {
        add_key(smooth_key(time, state), false);
        return;
    }
    const Key& last = dense_.back();
    if (!is_same(last.position, state.position) || !is_same(last.orientation, state.orientation) ||
        !is_same(last.velocity_out, state.velocity) ||
        !is_same(last.angular_velocity_out, state.angular_velocity)) {
        throw Error(
            fmt::format("track '{}': two different states at {:f} s without a break", name_, time));
    }
}

void TrackRecorder::add_break(double time, const MotionState& before, const MotionState& after) {
    if (!is_same(before.position, after.position) ||
        !is_same(before.orientation, after.orientation)) {
        throw Error(fmt::format("track '{}': the pose jumps at {:f} s", name_, time));
    }
    if (dense_.empty() || dense_.back().time != time) {
        Key key = smooth_key(time, before);
        key.velocity_out = after.velocity;
        key.angular_velocity_out = after.angular_velocity;
        add_key(key, !is_in_train(time, before, after));
        return;
    }
    Key& last = dense_.back();
    if (!is_same(last.position, before.position) ||
        !is_same(last.orientation, before.orientation)) {
        throw Error(fmt::format("track '{}': the pose jumps at {:f} s", name_, time));
    }
    last.velocity_out = after.velocity;
    last.angular_velocity_out = after.angular_velocity;
    if (!is_last_kept() && !is_in_train(time, before, after)) {
        keep_last();
    }
}

double TrackRecorder::add_jump(double time, const MotionState& before, const MotionState& after) {
    MotionState stopped = before;
    stopped.velocity = stopped.angular_velocity = Vec3(0, 0, 0);
    add_break(time, before, stopped);
    if (!is_last_kept()) {
        keep_last();
    }
    Key landed = smooth_key(time_after_jump(time), after);
    landed.velocity_in = landed.angular_velocity_in = Vec3(0, 0, 0);
    if (!is_same(before.orientation, after.orientation)) {
        throw Error(fmt::format("track '{}': the orientation jumps at {:f} s", name_, time));
    }
    add_key(landed, true);
    was_tiny_ = false;
    return landed.time;
}

Track TrackRecorder::finish() {
    if (!dense_.empty()) {
        if (!is_last_kept()) {
            keep_last();
        }
        reduce(0);
        if (keys_.empty()) {
            keys_.push_back(dense_.front());
        }
    }
    dense_.clear();
    kept_.clear();
    return Track(std::move(name_), std::move(keys_));
}

}  // namespace carom::sim
