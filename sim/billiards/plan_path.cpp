#include "sim/billiards/plan_path.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/assert.h"
#include "core/elementary.h"

namespace carom::sim::billiards {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kArcStep = kPi / 48;  // smallest step: a full circle has 96 corners
constexpr double kSagitta = 1e-5;      // m; small arcs have only as many corners as this requires
constexpr double kFlat = std::numeric_limits<double>::infinity();

Vec2 left_of(const Vec2& direction) {
    return {-direction.y, direction.x};
}
double cross(const Vec2& a, const Vec2& b) {
    return a.x * b.y - a.y * b.x;
}

Vec2 mitre_of(const Vec2& a, const Vec2& b) {
    return (a + b) / (1 + a.dot(b));
}

}  // namespace

Vec2 PathPoint::inside(double distance) const {
    return distance <= radius ? position - distance * mitre : tip - distance * tip_mitre;
}

Vec2 PathBuilder::open_normal(const Vec2& direction) const {
    const Vec2 left = left_of(direction);
    return open_side_ == OpenSide::left ? left : -left;
}

void PathBuilder::append(const Vec2& position, const Vec2& normal_before, const Vec2& normal_at) {
    PathPoint& last = points_.back();
    last.normal_out = normal_before;
    PathPoint point;
    point.position = position;
    point.normal_in = normal_at;
    point.radius = kFlat;
    point.length = last.length + (position - last.position).length();
    points_.push_back(point);
}

PathBuilder& PathBuilder::start(const Vec2& point) {
    points_.assign(1, PathPoint{});
    points_.back().position = point;
    points_.back().radius = kFlat;
    return *this;
}

PathBuilder& PathBuilder::line_to(const Vec2& point) {
    CAROM_ASSERT(!points_.empty());
    const Vec2 from = points_.back().position;
    const double length = (point - from).length();
    if (length < 1e-9) {
        return *this;
    }
    const Vec2 normal = open_normal((point - from) / length);
    const int count = std::max(1, static_cast<int>(std::ceil(length / longest_step_ - 1e-9)));
    for (int step = 1; step <= count; ++step) {
        append(step == count ? point : from + (point - from) * (double(step) / count), normal,
               normal);
    }
    return *this;
}

void PathBuilder::append_arc(const Vec2& centre, double radius, double begin_angle, double turn) {
    // A step of angle a has a sagitta of r a^2/8.
    const double arc_step = std::max(kArcStep, std::sqrt(8 * kSagitta / radius));
    const int count = std::max(1, static_cast<int>(std::ceil(std::abs(turn) / arc_step - 1e-9)));
    // The centre of a counter-clockwise arc is on its left.
    const double sign = (turn > 0) == (open_side_ == OpenSide::left) ? -1 : 1;
    const auto radial = [&](int step) {
        const double angle = begin_angle + turn * step / count;
        const SinCos at = sin_cos(angle);
        return Vec2(at.cos, at.sin);
    };
    for (int step = 1; step <= count; ++step) {
        append(centre + radius * radial(step), sign * radial(step - 1), sign * radial(step));
    }
}

PathBuilder& PathBuilder::arc_to(const Vec2& end, const Vec2& centre, bool is_counter_clockwise) {
    const Vec2 a = points_.back().position - centre;
    const Vec2 b = end - centre;
    const double begin_angle = arctangent2(a.y, a.x);
    double turn = arctangent2(cross(a, b), a.dot(b));
    if (is_counter_clockwise && turn < 0) {
        turn += 2 * kPi;
    }
    if (!is_counter_clockwise && turn > 0) {
        turn -= 2 * kPi;
    }
    append_arc(centre, a.length(), begin_angle, turn);
    points_.back().position = end;
    return *this;
}

PathBuilder& PathBuilder::round(const Vec2& tip, double radius, const Vec2& next) {
    const Vec2 before = (tip - points_.back().position).normalized();
    const Vec2 after = (next - tip).normalized();
    const double turn = arctangent2(cross(before, after), before.dot(after));
    const Vec2 mitre = mitre_of(open_normal(before), open_normal(after));
    const double tangent_length = radius * tangent(std::abs(turn) / 2);
    line_to(tip - tangent_length * before);
    const std::size_t first = points_.size() - 1;
    if (tangent_length > 0) {
        const double side = turn > 0 ? 1 : -1;
        const Vec2 centre = tip - tangent_length * before + side * radius * left_of(before);
        const Vec2 a = points_.back().position - centre;
        append_arc(centre, radius, arctangent2(a.y, a.x), turn);
        points_.back().position = tip + tangent_length * after;
    }
    // With material inside the bend, an offset into the material shrinks the rounding.
    const bool is_convex = (turn > 0) == (open_side_ == OpenSide::right);
    for (std::size_t index = first; is_convex && index < points_.size(); ++index) {
        points_[index].radius = radius;
        points_[index].tip = tip;
        points_[index].tip_mitre = mitre;
    }
    return *this;
}

void PathBuilder::set_mitres() {
    for (PathPoint& point : points_) {
        point.mitre = mitre_of(point.normal_in, point.normal_out);
    }
}

PlanPath PathBuilder::finish(const Vec2& cut_at_start, const Vec2& cut_at_end) {
    points_.front().normal_in = points_.front().normal_out;
    points_.back().normal_out = points_.back().normal_in;
    set_mitres();
    points_.front().mitre = cut_at_start / cut_at_start.dot(points_.front().normal_out);
    points_.back().mitre = cut_at_end / cut_at_end.dot(points_.back().normal_in);
    return points_;
}

PlanPath PathBuilder::finish() {
    return finish(points_.front().normal_out, points_.back().normal_in);
}

PlanPath PathBuilder::finish_closed() {
    const Vec2 first = points_.front().position;  // a copy: line_to moves the points
    line_to(first);
    points_.front().normal_in = points_.back().normal_in;
    points_.back().normal_out = points_.front().normal_out;
    set_mitres();
    return points_;
}

}  // namespace carom::sim::billiards
