// The mapping from positions in the scene to positions on the paper.
#pragma once

#include "core/vectors.h"

namespace carom::pipeline {

/// A rectangle of the scene, seen from above (+x to the right, +y up), drawn to scale.
struct Sheet {
    Vec2 low{0, 0}, high{1, 1};  // its corners, m
    double denominator = 10;     // of the scale: 15 for 1:15
    Vec2 corner{0, 0};           // position of (low.x, high.y) on the paper, mm

    [[nodiscard]] double length(double metres) const { return 1000 * metres / denominator; }
    [[nodiscard]] Vec2 at(const Vec2& place) const {
        return corner + Vec2(length(place.x - low.x), length(high.y - place.y));
    }
    [[nodiscard]] Vec2 at(const Vec3& place) const { return at(Vec2(place.x, place.y)); }
    [[nodiscard]] Vec2 size() const { return {length(high.x - low.x), length(high.y - low.y)}; }
};

/// The largest usual scale at which the rectangle fits on `room` (mm).
[[nodiscard]] Sheet make_sheet(const Vec2& low, const Vec2& high, const Vec2& room);

}  // namespace carom::pipeline
