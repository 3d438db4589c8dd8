// The pieces of which the motion of a body during one shutter consists (rigid_motion.h). Plain
// data; times are in shutter time, 0 when it opens and 1 when it closes.
#pragma once

#include <cstdint>

#include <Imath/ImathQuat.h>
#include <Imath/ImathVec.h>

#include "render/lanes/list.h"

namespace carom::render {

/// One cubic piece of a path: position(d) = c[0] + d (c[1] + d (c[2] + d c[3])) with
/// d = time - start. Valid while start <= time < end.
// Copying the array is the compiler's code:
// NOLINTNEXTLINE(bugprone-reserved-identifier,readability-identifier-naming)
struct PathPiece {
    Imath::V3f c[4] = {Imath::V3f(0), Imath::V3f(0), Imath::V3f(0), Imath::V3f(0)};
    float start = 0;
    float end = 1;

    [[nodiscard]] bool is_constant() const {
        const Imath::V3f zero(0, 0, 0);
        return c[1] == zero && c[2] == zero && c[3] == zero;
    }
};

/// A rotation by less than half a turn between two times, at a constant rate about a fixed axis.
struct RotationPiece {
    float start = 0;
    float inverse_duration = 0;      // 1 / (end - start), 0 without rotation
    Imath::V3f axis{0, 0, 1};        // unit, world axes
    float half_angle = 0;            // rad
    Imath::Quatf world_from_body{};  // at `start`
};

/// All pieces of a motion, in order of time; the first of each kind is valid from minus infinity,
/// the last to infinity. At least one of each.
struct MotionPieces {
    List<PathPiece> path;
    List<RotationPiece> turns;

    template <class Visit>
    void each_list(const Visit& visit) {
        visit(path, turns);
    }
};

}  // namespace carom::render
