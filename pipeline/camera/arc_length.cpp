#include "pipeline/camera/arc_length.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace carom::pipeline {
namespace {

constexpr int kMaxDepth = 20;  // bisections of one initial piece

struct Node {
    double position;  // in [-1, 1]
    double weight;
};

// Gauss-Legendre quadrature of 5 points, exact to degree 9 (Abramowitz and Stegun, "Handbook of
// Mathematical Functions", 1964, table 25.4).
constexpr std::array<Node, 5> kNodes{{{0, 0.568888888888888889},
                                      {-0.538469310105683091, 0.478628670499366468},
                                      {0.538469310105683091, 0.478628670499366468},
                                      {-0.906179845938663993, 0.236926885056189088},
                                      {0.906179845938663993, 0.236926885056189088}}};

double speed(const Curve& curve, double parameter) {
    return curve.derivative({parameter, 1 - parameter}).length();
}

// If the first control points coincide, the curve leaves towards the first one that differs.
Vec3 direction_at_start(const BezierCurve& curve) {
    for (const Vec3& point : curve.points()) {
        if (point != curve.points().front()) {
            return (point - curve.points().front()).normalized();
        }
    }
    return {0, 0, 0};
}

// Lexicographically, coordinate by coordinate.
bool is_reverse_smaller(const BezierCurve& curve) {
    const auto points = curve.points();
    return std::lexicographical_compare(points.rbegin(), points.rend(), points.begin(),
                                        points.end(), [](const Vec3& a, const Vec3& b) {
                                            return std::tie(a.x, a.y, a.z) <
                                                   std::tie(b.x, b.y, b.z);
                                        });
}

Vec3 position_from_start(const BezierCurve& curve, Progress fraction) {
    const ArcLengthTable table(curve);
    if (fraction.done <= 0) {
        return curve.points().front() +
               direction_at_start(curve) * (fraction.done * table.length());
    }
    const double parameter = table.parameter_at(fraction.done * table.length());
    return curve.position({parameter, 1 - parameter});
}

}  // namespace

ArcLengthTable::ArcLengthTable(const Curve& curve, int initial_pieces) : curve_(curve) {
    std::vector<double> lengths(static_cast<std::size_t>(initial_pieces));
    double estimate = 0;
    for (int i = 0; i < initial_pieces; ++i) {
        lengths[i] = length_between(double(i) / initial_pieces, double(i + 1) / initial_pieces);
        estimate += lengths[i];
    }
    const double tolerance = kEvenPaceError / 10 * estimate / initial_pieces;
    for (int i = 0; i < initial_pieces; ++i) {
        divide(double(i) / initial_pieces, double(i + 1) / initial_pieces, lengths[i], tolerance,
               0);
    }
}

double ArcLengthTable::length_between(double start, double end) const {
    const double middle = (start + end) / 2;
    const double half = (end - start) / 2;
    double sum = 0;
    for (const Node& node : kNodes) {
        sum += node.weight * speed(curve_, middle + half * node.position);
    }
    return sum * half;
}

// Appends the pieces of [start, end] in order. `length` is the length of [start, end] by one
// quadrature.
void ArcLengthTable::divide(double start, double end, double length, double tolerance, int depth) {
    const double middle = (start + end) / 2;
    const double left = length_between(start, middle);
    const double right = length_between(middle, end);
    if (depth == kMaxDepth || std::fabs(left + right - length) <= tolerance) {
        pieces_.push_back({start, middle, left, length_});
        length_ += left;
        pieces_.push_back({middle, end, right, length_});
        length_ += right;
        return;
    }
    divide(start, middle, left, tolerance / 2, depth + 1);
    divide(middle, end, right, tolerance / 2, depth + 1);
}

// Newton's method on the length within one piece, safeguarded by bisection of a bracket.
double ArcLengthTable::parameter_at(double travelled) const {
    auto piece = std::upper_bound(pieces_.begin(), pieces_.end(), travelled,
                                  [](double value, const Piece& p) { return value < p.before; });
    if (piece != pieces_.begin()) {
        --piece;
    }
    const double target = travelled - piece->before;
    if (!(piece->length > 0)) {
        return piece->start;
    }
    double low = piece->start;
    double high = piece->end;
    double parameter = low + (high - low) * std::clamp(target / piece->length, 0.0, 1.0);
    for (int i = 0; i < 60; ++i) {
        const double excess = length_between(piece->start, parameter) - target;
        if (std::fabs(excess) <= kEvenPaceError / 100 * length_) {
            break;
        }
        (excess > 0 ? high : low) = parameter;
        const double next = parameter - excess / speed(curve_, parameter);
        parameter = next > low && next < high ? next : (low + high) / 2;
    }
    return parameter;
}

Vec3 even_pace_position(const BezierCurve& curve, Progress fraction) {
    // The length is measured from the nearer end, so that both directions do the same arithmetic.
    const bool from_end = fraction.left < fraction.done ||
                          (fraction.left == fraction.done && is_reverse_smaller(curve));
    return from_end ? position_from_start(curve.reversed(), fraction.reversed())
                    : position_from_start(curve, fraction);
}

Vec3 even_pace_along(const Curve& curve, Progress fraction, int initial_pieces) {
    const ArcLengthTable table(curve, initial_pieces);
    const auto extrapolate = [&](Progress end, double distance) {
        const Vec3 slope = curve.derivative(end);
        return curve.position(end) + slope.normalized() * distance;  // a zero vector stays zero
    };
    if (fraction.done < 0) {
        return extrapolate({0, 1}, fraction.done * table.length());
    }
    if (fraction.left < 0) {
        return extrapolate({1, 0}, -fraction.left * table.length());
    }
    const double parameter = table.parameter_at(fraction.done * table.length());
    return curve.position({parameter, 1 - parameter});
}

}  // namespace carom::pipeline
