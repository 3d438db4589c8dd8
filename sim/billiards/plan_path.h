// Outlines in the plane of the cloth along which walls, cushions and rails are swept.
#pragma once

#include <vector>

#include "core/vectors.h"

namespace carom::sim::billiards {

/// The side of an outline, seen along its direction, that is free of material.
enum class OpenSide { left, right };

/// A point of an outline. At a sharp corner the normals before and after it differ.
struct PathPoint {
    Vec2 position{0, 0};
    Vec2 normal_in{0, 0};  // unit, towards the open side
    Vec2 normal_out{0, 0};
    Vec2 mitre{0, 0};  // mitre . normal = 1 for both normals
    Vec2 tip{0, 0};    // the corner that a rounding replaces, with its mitre
    Vec2 tip_mitre{0, 0};
    double radius = 0;  // of that rounding if it is convex; otherwise infinite
    double length = 0;  // arc length from the beginning of the outline, m

    /// The point of the outline offset by `distance` into the material. At offsets beyond its
    /// radius a rounding becomes a sharp corner.
    [[nodiscard]] Vec2 inside(double distance) const;
};

using PlanPath = std::vector<PathPoint>;

/// Builds an outline piece by piece.
class PathBuilder {
  public:
    /// Straight lines are divided into steps of at most `longest_step`.
    PathBuilder(OpenSide open_side, double longest_step)
        : open_side_(open_side), longest_step_(longest_step) {}

    PathBuilder& start(const Vec2& point);
    PathBuilder& line_to(const Vec2& point);

    /// Adds a line to the corner `tip`, which is rounded towards `next`, up to the end of the
    /// rounding.
    PathBuilder& round(const Vec2& tip, double radius, const Vec2& next);

    PathBuilder& arc_to(const Vec2& end, const Vec2& centre, bool is_counter_clockwise);

    /// An open outline, at whose ends the material is cut along these directions.
    [[nodiscard]] PlanPath finish(const Vec2& cut_at_start, const Vec2& cut_at_end);

    /// An open outline, cut at right angles at its ends.
    [[nodiscard]] PlanPath finish();

    /// A closed outline, whose last point repeats the first.
    [[nodiscard]] PlanPath finish_closed();

  private:
    [[nodiscard]] Vec2 open_normal(const Vec2& direction) const;
    void append(const Vec2& position, const Vec2& normal_before, const Vec2& normal_at);
    void append_arc(const Vec2& centre, double radius, double begin_angle, double turn);
    void set_mitres();

    OpenSide open_side_;
    double longest_step_;
    PlanPath points_;
};

}  // namespace carom::sim::billiards
