// Outlines in the plane of the cloth that walls, cushions and rails are drawn along.
#pragma once

#include <vector>

#include "core/vectors.h"

namespace carom::sim::billiards {

/// Which side of the direction of travel is open (free of material).
enum class OpenSide { left, right };

/// A point of an outline. Where the outline has a sharp corner the normals on arriving and on
/// leaving differ.
struct PathPoint {
    Vec2 position{0, 0};
    Vec2 normal_in{0, 0};  // unit, towards the open side
    Vec2 normal_out{0, 0};
    Vec2 mitre{0, 0};  // mitre . normal = 1 for both normals
    Vec2 tip{0, 0};    // of the corner that a rounding replaces, with its own mitre
    Vec2 tip_mitre{0, 0};
    double radius = 0;  // of that rounding, where it is convex; otherwise infinite
    double length = 0;  // along the outline from its beginning, m

    /// The same point of the outline moved by `distance` into the material. Past its radius a
    /// rounding has shrunk to a sharp corner.
    [[nodiscard]] Vec2 inside(double distance) const;
};

using PlanPath = std::vector<PathPoint>;

/// Builds an outline piece by piece.
class PathBuilder {
  public:
    /// Straight pieces longer than `longest_step` are divided.
    PathBuilder(OpenSide open_side, double longest_step)
        : open_side_(open_side), longest_step_(longest_step) {}

    PathBuilder& start(const Vec2& point);
    PathBuilder& line_to(const Vec2& point);

    /// To the corner `tip` and round it towards `next`, as far as the rounding goes.
    PathBuilder& round(const Vec2& tip, double radius, const Vec2& next);

    PathBuilder& arc_to(const Vec2& end, const Vec2& centre, bool is_counter_clockwise);

    /// Open outline; at its ends material is cut along these directions (not along the outline).
    [[nodiscard]] PlanPath finish(const Vec2& cut_at_start, const Vec2& cut_at_end);

    /// Open outline cut square at its ends.
    [[nodiscard]] PlanPath finish();

    /// The first point is repeated as the last.
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
