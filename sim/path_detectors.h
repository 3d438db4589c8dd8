// Detectors of what happens on the path of a body: it crosses a line, is highest, or comes to rest.
// The same code tells it while a simulation runs and finds it in a finished timeline.
#pragma once

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "core/vectors.h"
#include "sim/numeric/polynomial.h"

namespace carom::sim {

/// A part of the path of a body's centre: the sum of coefficients[i] t^i, t in s since its start.
struct PathPiece {
    double length = 0;  // s
    std::array<Vec3, 4> coefficients{};

    [[nodiscard]] Quartic component(const Vec3& axis) const;
};

/// A detector follows a path piece by piece, each from where the last one ended. `follow` returns
/// the times (s since the piece's start), in order, at which it happens on the piece. What may be
/// cut short is predicted with a copy: then the detector itself is told only where the piece begins
/// (`begin`), and that the predicted event has happened (`note`).
///
/// The centre, seen from above, passes through the line segment between two different points (m)
/// from one side to the other. A body that starts on the line does not cross it by leaving.
class LineDetector {
  public:
    LineDetector(const Vec2& from, const Vec2& to);

    [[nodiscard]] std::vector<double> follow(const PathPiece& piece);
    void begin(const PathPiece& piece);
    void note() { side_ = -side_; }

  private:
    [[nodiscard]] PathPiece from_origin(const PathPiece& piece) const;

    Vec3 origin_, along_, across_;  // level; the latter two are unit
    double length_;
    int side_ = 0;  // on which the body last was clearly; 0: on neither yet
};

/// The body stops to rise after it rose by at least kMinRise without a pause.
class ApexDetector {
  public:
    [[nodiscard]] std::vector<double> follow(const PathPiece& piece);
    void begin(const PathPiece& piece);
    void note() { rises_from_.reset(); }

  private:
    std::optional<double> rises_from_;  // height (m) at which it began to rise
};

/// Whether a motion can be seen: something is `distance` (m) from where it last rested, moves at
/// `speed` (m/s) and turns at `spin` (rad/s).
[[nodiscard]] bool is_visible(double distance, double speed, double spin);

/// The body, or all bodies, come to rest after a motion that can be seen.
class RestDetector {
  public:
    void move(bool visibly) { has_moved_ = has_moved_ || visibly; }
    [[nodiscard]] bool has_moved() const { return has_moved_; }
    /// They are at rest: true if that ends a motion.
    [[nodiscard]] bool rest() { return std::exchange(has_moved_, false); }

  private:
    bool has_moved_ = false;  // since the last rest
};

}  // namespace carom::sim
