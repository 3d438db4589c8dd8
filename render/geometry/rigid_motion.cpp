#include "render/geometry/rigid_motion.h"

#include <algorithm>
#include <cmath>

#include "core/assert.h"
#include "sim/timeline/rotation.h"

namespace carom::render {
namespace {

constexpr double kTurnTolerance = 3e-5;       // rad, at the times that are checked
constexpr double kLargestTurn = 1.0;          // rad in one piece
constexpr float kBetweenOrientations = 0.1f;  // rad, from one of `orientations` to the next
constexpr int kDeepest = 14;                  // bisections of one segment of the path
constexpr float kRoundingFraction = 1e-5f;    // of the coordinates, by which bounds are widened

Imath::Quatf narrowed(const Quat& q) {
    return Imath::Quatf(static_cast<float>(q.r), V3f(q.v)).normalized();
}

/// The Hermite segment as a cubic in shutter time; `shutter` is the length of the shutter in s.
PathPiece make_piece(const sim::PathSegment& segment, double scene_open, double shutter) {
    PathPiece piece;
    piece.c[0] = V3f(segment.p0);
    const double h = segment.end - segment.start;
    if (!(shutter > 0) || !(h > 0)) {
        return piece;
    }
    const Vec3 chord = segment.p1 - segment.p0;
    const Vec3 quadratic = 3.0 * chord - h * (2.0 * segment.v0 + segment.v1);
    const Vec3 cubic = h * (segment.v0 + segment.v1) - 2.0 * chord;
    const double scale = shutter / h;
    piece.c[1] = V3f(shutter * segment.v0);
    piece.c[2] = V3f(scale * scale * quadratic);
    piece.c[3] = V3f(scale * scale * scale * cubic);
    piece.start = static_cast<float>((segment.start - scene_open) / shutter);
    piece.end = static_cast<float>((segment.end - scene_open) / shutter);
    return piece;
}

Imath::Box3f widened(const sim::Bounds& bounds) {
    Imath::Box3f box(V3f(bounds.low), V3f(bounds.high));
    for (int axis = 0; axis < 3; ++axis) {
        const float size = std::max(std::abs(box.min[axis]), std::abs(box.max[axis]));
        box.min[axis] -= kRoundingFraction * size;
        box.max[axis] += kRoundingFraction * size;
    }
    return box;
}

Imath::Quatf quaternion_of(const scalar::RotationOf<scalar::One>& rotation) {
    return {rotation.real, rotation.vector};
}

/// The orientation after this part of the piece, in [0, 1].
Imath::Quatf turned(const RotationPiece& piece, float fraction) {
    return quaternion_of(scalar::rotation_after<scalar::One>(
        scalar::rotation_of(piece.world_from_body), piece.axis, fraction * piece.half_angle));
}

/// The rotation between two orientations, by less than half a turn.
Vec3 turn_between(const Quat& from, const Quat& to) {
    return sim::rotation_vector(to * ~from);
}

}  // namespace

RigidMotion::RigidMotion(const Pose& pose) {
    PathPiece piece;
    piece.c[0] = V3f(pose.position);
    path_.push_back(piece);
    RotationPiece turn;
    turn.world_from_body = narrowed(pose.orientation);
    turns_.push_back(turn);
    bounds_ = widened({pose.position, pose.position});
}

RigidMotion::RigidMotion(const sim::Track& track, double scene_open, double scene_close) {
    CAROM_ASSERT(scene_open <= scene_close);
    const double shutter = scene_close - scene_open;
    for (const sim::PathSegment& segment : track.segments(scene_open, scene_close)) {
        path_.push_back(make_piece(segment, scene_open, shutter));
        add_turns(track, scene_open, scene_close, segment.start, segment.end, 0);
    }
    join_rests();
    for (std::size_t i = 0; i + 1 < path_.size(); ++i) {
        path_[i].end = path_[i + 1].start;
    }
    bounds_ = widened(track.position_bounds(scene_open, scene_close));
}

void RigidMotion::join_rests() {
    const auto same_rest = [](const PathPiece& a, const PathPiece& b) {
        return a.is_constant() && b.is_constant() && a.c[0] == b.c[0];
    };
    path_.erase(std::unique(path_.begin(), path_.end(), same_rest), path_.end());
    const auto same_stand = [](const RotationPiece& a, const RotationPiece& b) {
        return a.half_angle == 0 && b.half_angle == 0 && a.world_from_body == b.world_from_body;
    };
    turns_.erase(std::unique(turns_.begin(), turns_.end(), same_stand), turns_.end());
}

void RigidMotion::add_turns(const sim::Track& track, double scene_open, double scene_close,
                            double from, double to, int depth) {
    const double shutter = scene_close - scene_open;
    const MotionState begin = track.sample(from);
    RotationPiece piece;
    piece.world_from_body = narrowed(begin.orientation);
    if (!(shutter > 0) || !(to > from)) {
        turns_.push_back(piece);
        return;
    }
    const double middle = 0.5 * (from + to);
    const MotionState halfway = track.sample(middle);
    const Vec3 turn = turn_between(begin.orientation, track.sample(to).orientation);
    // The angular velocity is linear within a segment, so that its ends bound it.
    const Vec3 rate_at_end = 2.0 * halfway.angular_velocity - begin.angular_velocity;
    const double rate = std::max(begin.angular_velocity.length(), rate_at_end.length());
    const double error = sim::angle_between(
        sim::rotation_from_vector(0.5 * turn) * begin.orientation, halfway.orientation);
    if ((rate * (to - from) > kLargestTurn || error > kTurnTolerance) && depth < kDeepest) {
        add_turns(track, scene_open, scene_close, from, middle, depth + 1);
        add_turns(track, scene_open, scene_close, middle, to, depth + 1);
        return;
    }
    const double angle = turn.length();
    piece.start = static_cast<float>((from - scene_open) / shutter);
    if (angle > 0) {
        piece.inverse_duration = static_cast<float>(shutter / (to - from));
        piece.axis = V3f(turn / angle);
        piece.half_angle = static_cast<float>(0.5 * angle);
    }
    turns_.push_back(piece);
}

V3f RigidMotion::position(float time) const {
    return scalar::position_at<scalar::One>(pieces(), time);
}

Imath::Quatf RigidMotion::world_from_body(float time) const {
    return quaternion_of(scalar::rotation_at<scalar::One>(pieces(), time));
}

RigidMotion::Orientations RigidMotion::orientations() const {
    Orientations result;
    for (const RotationPiece& piece : turns_) {
        const float whole = 2 * piece.half_angle;
        const int steps = 1 + static_cast<int>(std::min(whole / kBetweenOrientations, 63.f));
        for (int i = 0; i <= steps; ++i) {
            const float fraction = static_cast<float>(i) / static_cast<float>(steps);
            result.world_from_body.push_back(turned(piece, fraction));
        }
        result.within = std::max(result.within, 0.5f * whole / static_cast<float>(steps));
    }
    return result;
}

bool RigidMotion::is_static() const {
    return path_.size() == 1 && path_[0].is_constant() && turns_.size() == 1 &&
           turns_[0].half_angle == 0;
}

}  // namespace carom::render
