// Parametrisation of a curve by arc length, for motion at constant speed.
#pragma once

#include <vector>

#include "pipeline/camera/bezier.h"

namespace carom::pipeline {

/// Largest error of the arc length at the returned point, as a fraction of the curve's length. At a
/// cusp (zero derivative), pieces shorter than 2^-23 of the parameter are not divided further, even
/// if the error is larger.
inline constexpr double kEvenPaceError = 1e-9;

/// Maps the arc length from a curve's start to the curve's parameter.
class ArcLengthTable {
  public:
    /// The parameter range is first divided into `initial_pieces` equal pieces, and each is then
    /// refined. A curve made of several segments needs at least one piece per segment.
    explicit ArcLengthTable(const Curve& curve, int initial_pieces = 8);

    [[nodiscard]] double length() const { return length_; }  // m

    /// `travelled` in [0, length()], m; the parameter is in [0, 1].
    [[nodiscard]] double parameter_at(double travelled) const;

  private:
    struct Piece {
        double start;   // parameter
        double end;     // parameter
        double length;  // m, of this piece
        double before;  // m, total length of the pieces before it
    };

    [[nodiscard]] double length_between(double start, double end) const;
    void divide(double start, double end, double length, double tolerance, int depth);

    const Curve& curve_;
    std::vector<Piece> pieces_;
    double length_ = 0;
};

/// The point at the fraction `fraction.done` of the curve's length. Beyond the ends the point
/// continues along the tangent at the same speed. The reversed curve at the reversed fraction gives
/// the same bits.
[[nodiscard]] Vec3 even_pace_position(const BezierCurve& curve, Progress fraction);

/// Like even_pace_position for any curve, but always measured from its start.
[[nodiscard]] Vec3 even_pace_along(const Curve& curve, Progress fraction, int initial_pieces);

}  // namespace carom::pipeline
