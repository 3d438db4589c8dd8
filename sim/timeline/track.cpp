#include "sim/timeline/track.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <fmt/core.h>

#include "core/assert.h"
#include "core/error.h"
#include "core/finite.h"
#include "sim/timeline/hermite.h"
#include "sim/timeline/rotation_segment.h"

namespace carom::sim {

namespace {

constexpr std::uint32_t kCheckpointSpacing = 16;  // substeps

/// A path this long (m) within one number of time is a jump. Objects at 100 m/s move by less than
/// 1e-10 m.
constexpr double kMinJump = 1e-6;

bool has_finite_values(const Key& key) {
    return std::isfinite(key.time) && is_finite(key.position) && is_finite(key.orientation) &&
           is_finite(key.velocity_in) && is_finite(key.velocity_out) &&
           is_finite(key.angular_velocity_in) && is_finite(key.angular_velocity_out);
}

bool is_jump(const Key& from, const Key& to) {
    const Vec3 way = to.position - from.position;
    return to.time == time_after_jump(from.time) && way.dot(way) > kMinJump * kMinJump;
}

RotationSegment rotation_between(const Key& from, const Key& to) {
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

/// Throws an Error that names the track and the key.
void check_keys(const std::string& name, std::span<const Key> keys) {
    if (keys.empty()) {
        throw Error("track '" + name + "' has no keys");
    }
    for (std::size_t index = 0; index < keys.size(); ++index) {
        const Key& key = keys[index];
        const auto refuse = [&](const std::string& what) {
            throw Error(fmt::format("track '{}', key {}: {}", name, index, what));
        };
        if (!has_finite_values(key)) {
            refuse("a value is not finite");
        }
        const double length2 = key.orientation ^ key.orientation;
        if (!(std::abs(length2 - 1) <= 2e-6)) {
            refuse("the orientation is not a unit quaternion");
        }
        if (index > 0 && !(keys[index - 1].time < key.time)) {
            refuse("its time is not later than that of the previous key");
        }
    }
    if (rotation_substeps(keys) > kMaxSubsteps) {
        throw Error("track '" + name + "' turns more than 1e6 rad about changing axes");
    }
}

}  // namespace

double time_after_jump(double time) {
    return std::nextafter(time, std::numeric_limits<double>::infinity());
}

Track::Track(std::string name, std::vector<Key> keys)
    : data_(std::make_shared<const Data>(prepare(std::move(name), std::move(keys)))) {}

Track::Data Track::prepare(std::string name, std::vector<Key> keys) {
    check_keys(name, keys);
    Data data{std::move(name), std::move(keys), {}, {}, {}, {}};
    data.times.reserve(data.keys.size());
    for (const Key& key : data.keys) {
        data.times.push_back(key.time);
    }
    data.intervals.resize(data.keys.size() - 1);
    for (std::size_t index = 0; index < data.intervals.size(); ++index) {
        const RotationSegment rotation = rotation_between(data.keys[index], data.keys[index + 1]);
        data.intervals[index].first_checkpoint = data.checkpoints.size();
        Quat orientation = data.keys[index].orientation;
        for (std::uint32_t substep = 0; substep < rotation.substeps();) {
            data.checkpoints.push_back(orientation);
            const std::uint32_t next = std::min(substep + kCheckpointSpacing, rotation.substeps());
            orientation = rotation.advance(orientation, substep, next);
            substep = next;
        }
        data.intervals[index].residual =
            rotation_vector(data.keys[index + 1].orientation * ~orientation);
        if (is_jump(data.keys[index], data.keys[index + 1])) {
            data.jumps.push_back(index);
        }
    }
    return data;
}

bool Track::jumps_after(std::size_t index) const {
    return std::binary_search(data_->jumps.begin(), data_->jumps.end(), index);
}

// Index of the last key at or before the time, which is not before the first key. At the instant of
// a jump it is the key after it.
std::size_t Track::last_key_at(double scene_time) const {
    const auto after = std::upper_bound(data_->times.begin(), data_->times.end(), scene_time);
    CAROM_ASSERT(after != data_->times.begin());
    auto index = static_cast<std::size_t>(after - data_->times.begin()) - 1;
    while (jumps_after(index) && scene_time == data_->times[index]) {
        ++index;
        scene_time = data_->times[index];
    }
    return index;
}

PathSegment Track::segment_after(std::size_t index) const {
    const Key& from = data_->keys[index];
    const Key& to = data_->keys[index + 1];
    return {from.time, to.time, from.position, to.position, from.velocity_out, to.velocity_in};
}

Quat Track::orientation_in(std::size_t index, double scene_time) const {
    const Key& from = data_->keys[index];
    const Key& to = data_->keys[index + 1];
    const KeyInterval& interval = data_->intervals[index];
    const RotationSegment rotation = rotation_between(from, to);
    const double elapsed = scene_time - from.time;
    const std::uint32_t substep = rotation.substep_at(elapsed);
    const std::uint32_t checkpoint = substep / kCheckpointSpacing;
    Quat orientation = rotation.advance(data_->checkpoints[interval.first_checkpoint + checkpoint],
                                        checkpoint * kCheckpointSpacing, substep);
    orientation = rotation.finish(orientation, substep, elapsed);
    if (interval.residual == Vec3(0)) {
        return orientation;
    }
    const double fraction = elapsed / (to.time - from.time);
    return (rotation_from_vector(fraction * interval.residual) * orientation).normalized();
}

MotionState Track::sample(double scene_time) const {
    const Key& first = data_->keys.front();
    const Key& last = data_->keys.back();
    if (scene_time < first.time) {
        return {first.position, first.orientation, Vec3(0), Vec3(0)};
    }
    if (!(scene_time <= last.time)) {
        return {last.position, last.orientation, Vec3(0), Vec3(0)};
    }
    const std::size_t index = last_key_at(scene_time);
    const Key& key = data_->keys[index];
    if (scene_time <= key.time) {  // less only at the instant of a jump
        return {key.position, key.orientation, key.velocity_out, key.angular_velocity_out};
    }
    const PathSegment segment = segment_after(index);
    return {hermite_position(segment, scene_time), orientation_in(index, scene_time),
            hermite_velocity(segment, scene_time),
            rotation_between(key, data_->keys[index + 1]).angular_velocity(scene_time - key.time)};
}

std::vector<Track::Piece> Track::pieces(double from, double to) const {
    CAROM_ASSERT(from <= to);
    const Key& first = data_->keys.front();
    const Key& last = data_->keys.back();
    std::vector<Piece> pieces;
    const auto add_rest = [&](const Vec3& position, double begin, double end) {
        const PathSegment rest{begin, end, position, position, Vec3(0), Vec3(0)};
        pieces.push_back({rest, begin, end});
    };
    if (from < first.time) {
        add_rest(first.position, from, std::min(to, first.time));
    }
    if (to > first.time && from < last.time) {
        const double begin = std::max(from, first.time);
        for (std::size_t index = last_key_at(begin);
             index < data_->intervals.size() && data_->keys[index].time < to; ++index) {
            if (jumps_after(index)) {
                continue;
            }
            const PathSegment whole = segment_after(index);
            pieces.push_back({whole, std::max(begin, whole.start), std::min(to, whole.end)});
        }
    }
    if (to > last.time) {
        add_rest(last.position, std::max(from, last.time), to);
    }
    if (pieces.empty()) {  // from == to at a key
        const MotionState state = sample(from);
        const PathSegment instant{from,          to, state.position, state.position, state.velocity,
                                  state.velocity};
        pieces.push_back({instant, from, to});
    }
    return pieces;
}

std::vector<PathSegment> Track::segments(double from, double to) const {
    std::vector<PathSegment> segments;
    for (const Piece& piece : pieces(from, to)) {
        segments.push_back(cut(piece.segment, piece.from, piece.to));
    }
    return segments;
}

Bounds Track::position_bounds(double from, double to) const {
    std::optional<Bounds> bounds;
    for (const Piece& piece : pieces(from, to)) {
        const Bounds box = bounds_of(piece.segment, piece.from, piece.to);
        bounds = bounds ? united(*bounds, box) : box;
    }
    return *bounds;
}

}  // namespace carom::sim
