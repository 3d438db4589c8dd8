#include "sim/timeline/track.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/core.h>

#include "core/assert.h"
#include "core/error.h"
#include "core/finite.h"
#include "sim/timeline/hermite.h"
#include "sim/timeline/turning.h"

namespace carom::sim {

namespace {

constexpr std::uint32_t kCheckpointSpacing = 16;  // substeps

bool has_finite_values(const Key& key) {
    return std::isfinite(key.time) && is_finite(key.position) && is_finite(key.orientation) &&
           is_finite(key.velocity_in) && is_finite(key.velocity_out) &&
           is_finite(key.angular_velocity_in) && is_finite(key.angular_velocity_out);
}

Turning turning_between(const Key& from, const Key& to) {
    return {from.angular_velocity_out, to.angular_velocity_in, to.time - from.time};
}

Bounds united(const Bounds& a, const Bounds& b) {
    Bounds both;
    for (int axis = 0; axis < 3; ++axis) {
        both.low[axis] = std::min(a.low[axis], b.low[axis]);
        both.high[axis] = std::max(a.high[axis], b.high[axis]);
    }
    return both;
}

}  // namespace

Track::Track(std::string name, std::vector<Key> keys)
    : name_(std::move(name)), keys_(std::move(keys)) {
    check_keys();
    times_.reserve(keys_.size());
    for (const Key& key : keys_) {
        times_.push_back(key.time);
    }
    prepare_segments();
}

void Track::check_keys() const {
    if (keys_.empty()) {
        throw Error("track '" + name_ + "' has no keys");
    }
    for (std::size_t index = 0; index < keys_.size(); ++index) {
        const Key& key = keys_[index];
        const auto refuse = [&](const std::string& what) {
            throw Error(fmt::format("track '{}', key {}: {}", name_, index, what));
        };
        if (!has_finite_values(key)) {
            refuse("a value is not finite");
        }
        const double length2 = key.orientation ^ key.orientation;
        if (!(std::abs(length2 - 1) <= 2e-6)) {
            refuse("the orientation is not a unit quaternion");
        }
        if (index > 0 && !(keys_[index - 1].time < key.time)) {
            refuse("its time is not after that of the key before");
        }
    }
    if (turn_substeps(keys_) > kMostSubsteps) {
        throw Error("track '" + name_ + "' turns more than 1e6 rad about changing axes");
    }
}

void Track::prepare_segments() {
    segments_.resize(keys_.size() - 1);
    for (std::size_t index = 0; index < segments_.size(); ++index) {
        const Turning turning = turning_between(keys_[index], keys_[index + 1]);
        segments_[index].first_checkpoint = checkpoints_.size();
        Quat orientation = keys_[index].orientation;
        for (std::uint32_t substep = 0; substep < turning.substeps();) {
            checkpoints_.push_back(orientation);
            const std::uint32_t next = std::min(substep + kCheckpointSpacing, turning.substeps());
            orientation = turning.advance(orientation, substep, next);
            substep = next;
        }
        segments_[index].residual = rotation_vector(keys_[index + 1].orientation * ~orientation);
    }
}

// The last key at or before the time, which is not before the first.
std::size_t Track::last_key_at(double scene_time) const {
    const auto after = std::upper_bound(times_.begin(), times_.end(), scene_time);
    CAROM_ASSERT(after != times_.begin());
    return static_cast<std::size_t>(after - times_.begin()) - 1;
}

PathStretch Track::segment_stretch(std::size_t index) const {
    const Key& from = keys_[index];
    const Key& to = keys_[index + 1];
    return {from.time, to.time, from.position, to.position, from.velocity_out, to.velocity_in};
}

Quat Track::orientation_in(std::size_t index, double scene_time) const {
    const Key& from = keys_[index];
    const Key& to = keys_[index + 1];
    const Segment& segment = segments_[index];
    const Turning turning = turning_between(from, to);
    const double elapsed = scene_time - from.time;
    const std::uint32_t substep = turning.substep_at(elapsed);
    const std::uint32_t checkpoint = substep / kCheckpointSpacing;
    Quat orientation = turning.advance(checkpoints_[segment.first_checkpoint + checkpoint],
                                       checkpoint * kCheckpointSpacing, substep);
    orientation = turning.finish(orientation, substep, elapsed);
    if (segment.residual == Vec3(0)) {
        return orientation;
    }
    const double share = elapsed / (to.time - from.time);
    return (rotation_from_vector(share * segment.residual) * orientation).normalized();
}

MotionState Track::sample(double scene_time) const {
    const Key& first = keys_.front();
    const Key& last = keys_.back();
    if (scene_time < first.time) {
        return {first.position, first.orientation, Vec3(0), Vec3(0)};
    }
    if (!(scene_time <= last.time)) {
        return {last.position, last.orientation, Vec3(0), Vec3(0)};
    }
    const std::size_t index = last_key_at(scene_time);
    const Key& key = keys_[index];
    if (scene_time == key.time) {
        return {key.position, key.orientation, key.velocity_out, key.angular_velocity_out};
    }
    const PathStretch stretch = segment_stretch(index);
    return {hermite_position(stretch, scene_time), orientation_in(index, scene_time),
            hermite_velocity(stretch, scene_time),
            turning_between(key, keys_[index + 1]).angular_velocity(scene_time - key.time)};
}

std::vector<Track::Piece> Track::pieces(double from, double to) const {
    CAROM_ASSERT(from <= to);
    const Key& first = keys_.front();
    const Key& last = keys_.back();
    std::vector<Piece> pieces;
    const auto add_rest = [&](const Vec3& position, double begin, double end) {
        const PathStretch rest{begin, end, position, position, Vec3(0), Vec3(0)};
        pieces.push_back({rest, begin, end});
    };
    if (from < first.time) {
        add_rest(first.position, from, std::min(to, first.time));
    }
    if (to > first.time && from < last.time) {
        const double begin = std::max(from, first.time);
        for (std::size_t index = last_key_at(begin);
             index < segments_.size() && keys_[index].time < to; ++index) {
            const PathStretch whole = segment_stretch(index);
            pieces.push_back({whole, std::max(begin, whole.start), std::min(to, whole.end)});
        }
    }
    if (to > last.time) {
        add_rest(last.position, std::max(from, last.time), to);
    }
    if (pieces.empty()) {  // from == to at a key
        const MotionState state = sample(from);
        const PathStretch instant{from,          to, state.position, state.position, state.velocity,
                                  state.velocity};
        pieces.push_back({instant, from, to});
    }
    return pieces;
}

std::vector<PathStretch> Track::stretches(double from, double to) const {
    std::vector<PathStretch> stretches;
    for (const Piece& piece : pieces(from, to)) {
        stretches.push_back(cut(piece.stretch, piece.from, piece.to));
    }
    return stretches;
}

Bounds Track::position_bounds(double from, double to) const {
    std::optional<Bounds> bounds;
    for (const Piece& piece : pieces(from, to)) {
        const Bounds box = bounds_of(piece.stretch, piece.from, piece.to);
        bounds = bounds ? united(*bounds, box) : box;
    }
    return *bounds;
}

}  // namespace carom::sim
