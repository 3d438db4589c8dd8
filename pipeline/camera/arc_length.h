// Moving along a curve at an even pace.
#pragma once

#include <vector>

#include "pipeline/camera/bezier.h"

namespace carom::pipeline {

/// How far the length travelled at the point returned may be from the one asked for, as a share of
/// the whole curve. At a cusp (zero derivative) pieces shorter than 2^-23 of the parameter are not
/// divided further, whatever the error.
inline constexpr double kEvenPaceError = 1e-9;

/// A curve's parameter by the length travelled from its start.
class ArcLengthTable {
  public:
    /// `first_pieces`: how many stretches are looked at for detail of their own; a curve made of
    /// several parts needs some in each.
    explicit ArcLengthTable(const Curve& curve, int first_pieces = 8);

    [[nodiscard]] double length() const { return length_; }  // m

    /// `travelled` in [0, length()], m; the parameter is in [0, 1].
    [[nodiscard]] double parameter_at(double travelled) const;

  private:
    struct Piece {
        double start;   // parameter
        double end;     // parameter
        double length;  // m, of this piece
        double before;  // m, of all pieces before it
    };

    [[nodiscard]] double length_between(double start, double end) const;
    void divide(double start, double end, double length, double tolerance, int depth);

    const Curve& curve_;
    std::vector<Piece> pieces_;
    double length_ = 0;
};

/// The point at `share.done` of the curve's length; beyond the ends straight on at the same pace.
/// The reversed curve at the reversed share gives the same bits.
[[nodiscard]] Vec3 even_pace_position(const BezierCurve& curve, Progress fraction);

/// The same for any curve, always measured from its start.
[[nodiscard]] Vec3 even_pace_along(const Curve& curve, Progress fraction, int first_pieces);

}  // namespace carom::pipeline
