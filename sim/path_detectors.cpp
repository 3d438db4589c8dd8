#include "sim/path_detectors.h"

#include <algorithm>
#include <cmath>

#include "sim/force_event.h"
#include "sim/numeric/tolerances.h"

namespace carom::sim {
namespace {

/// -1, 0 or 1: the side of a line at that distance.
int side_at(double distance) {
    return std::abs(distance) < kOnLine ? 0 : distance > 0 ? 1 : -1;
}

Quartic derivative(const Quartic& c) {
    return {c[1], 2 * c[2], 3 * c[3], 4 * c[4], 0};
}

/// Calls `visit(time, value)` for each interval of [0, length] between sign changes, with its start
/// and a value of the polynomial within it.
template <class Visit>
void visit_intervals(const Quartic& polynomial, double length, const Visit& visit) {
    std::array<double, 4> roots{};
    const std::size_t count = sign_changes(polynomial, 0, length, roots);
    double from = 0;
    for (std::size_t i = 0; i <= count; ++i) {
        const double to = i < count ? roots[i] : length;
        visit(from, evaluate(polynomial, 0.5 * (from + to)));
        from = to;
    }
}

}  // namespace

Quartic PathPiece::component(const Vec3& axis) const {
    return {coefficients[0].dot(axis), coefficients[1].dot(axis), coefficients[2].dot(axis),
            coefficients[3].dot(axis), 0};
}

LineDetector::LineDetector(const Vec2& from, const Vec2& to) : origin_(from.x, from.y, 0) {
    const Vec2 span = to - from;
    length_ = std::sqrt(span.dot(span));
    along_ = Vec3(span.x / length_, span.y / length_, 0);
    across_ = Vec3(-along_.y, along_.x, 0);
}

PathPiece LineDetector::from_origin(const PathPiece& piece) const {
    PathPiece moved = piece;
    moved.coefficients[0] -= origin_;
    return moved;
}

void LineDetector::begin(const PathPiece& piece) {
    const int side = side_at((piece.coefficients[0] - origin_).dot(across_));
    side_ = side != 0 ? side : side_;
}

/// Where the body begins clearly on one side, it does not matter where it was: it may have been put
/// there.
std::vector<double> LineDetector::follow(const PathPiece& piece) {
    begin(piece);
    const PathPiece moved = from_origin(piece);
    const Quartic position = moved.component(along_);
    std::vector<double> times;
    visit_intervals(moved.component(across_), piece.length * (1 + 1e-15),
                    [&](double start, double distance) {
                        const int side = side_at(distance);
                        if (side == 0 || side == side_) {
                            return;
                        }
                        const double time = std::min(start, piece.length);
                        const double place = evaluate(position, time);
                        if (side_ != 0 && place >= 0 && place <= length_) {
                            times.push_back(time);
                        }
                        side_ = side;
                    });
    return times;
}

void ApexDetector::begin(const PathPiece& piece) {
    if (piece.coefficients[1].z <= 0) {
        rises_from_.reset();
    } else if (!rises_from_) {
        rises_from_ = piece.coefficients[0].z;
    }
}

std::vector<double> ApexDetector::follow(const PathPiece& piece) {
    const Quartic height = piece.component(Vec3(0, 0, 1));
    std::vector<double> times;
    visit_intervals(derivative(height), piece.length, [&](double start, double speed) {
        if (speed > 0) {
            rises_from_ = rises_from_.value_or(evaluate(height, start));
        } else if (rises_from_) {
            if (evaluate(height, start) - *rises_from_ >= kMinRise) {
                times.push_back(start);
            }
            rises_from_.reset();
        }
    });
    return times;
}

bool is_visible(double distance, double speed, double spin) {
    return distance > kMinDisplacement || speed > kVisibleSpeed || spin > kVisibleSpin;
}

}  // namespace carom::sim
