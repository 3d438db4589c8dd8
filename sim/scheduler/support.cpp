#include "sim/scheduler/support.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/length.h"
#include "core/rigid.h"

namespace carom::sim {
namespace {

/// A contact pushes a body up or sideways if its normal descends by less than this sine; otherwise
/// it is a load on the body.
constexpr double kLoadSlope = 0.05;
/// A centre of mass this far (m) beside the only supporting point or line counts as straight above
/// it, for bodies that may roll there and for bodies balanced there. The latter value allows only
/// for rounding.
constexpr double kBesideRolling = 1e-6;
constexpr double kBesideBalanced = 1e-12;
/// A contact is level if its normal rises by more than this sine.
constexpr double kLevelNormal = 0.99;
/// A capsule or cylinder lies on its side if its axis rises by less than this sine.
constexpr double kLevelAxis = 0.01;

double cross(const Vec2& a, const Vec2& b) {
    return a.x * b.y - a.y * b.x;
}

/// Projection along `up`.
class HorizontalProjection {
  public:
    explicit HorizontalProjection(const Vec3& up) {
        const Vec3 other = std::abs(up.x) < 0.9 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
        right_ = up.cross(other);
        right_ /= length(right_);
        forward_ = up.cross(right_);
    }
    [[nodiscard]] Vec2 operator()(const Vec3& p) const { return {p.dot(right_), p.dot(forward_)}; }

  private:
    Vec3 right_, forward_;
};

/// Corners of the convex hull, counter-clockwise (Andrew, Another efficient algorithm for convex
/// hulls in two dimensions, Inf. Process. Lett. 9, 1979). One or two corners if all points coincide
/// or lie on a line.
std::vector<Vec2> hull_of(std::vector<Vec2> points) {
    if (points.size() < 2) {
        return points;
    }
    std::sort(points.begin(), points.end(),
              [](const Vec2& a, const Vec2& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
    std::vector<Vec2> hull;
    for (const bool is_lower : {true, false}) {
        const std::size_t start = hull.size();
        for (const Vec2& point : points) {
            while (hull.size() >= start + 2 &&
                   cross(hull.back() - hull[hull.size() - 2], point - hull.back()) <= 0) {
                hull.pop_back();
            }
            hull.push_back(point);
        }
        hull.pop_back();  // it begins the other half
        if (is_lower) {
            std::reverse(points.begin(), points.end());
        }
    }
    return hull;
}

double distance_to_segment(const Vec2& p, const Vec2& a, const Vec2& b) {
    const Vec2 along = b - a;
    const double square = along.dot(along);
    const double fraction = square > 0 ? std::clamp((p - a).dot(along) / square, 0.0, 1.0) : 0;
    return (p - a - along * fraction).length();
}

double distance_to_outline(const Vec2& p, const std::vector<Vec2>& hull) {
    double least = (p - hull.front()).length();
    for (std::size_t i = 0; i < hull.size(); ++i) {
        least = std::min(least, distance_to_segment(p, hull[i], hull[(i + 1) % hull.size()]));
    }
    return least;
}

bool is_inside(const Vec2& p, const std::vector<Vec2>& hull) {
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const Vec2& corner = hull[i];
        if (cross(hull[(i + 1) % hull.size()] - corner, p - corner) <= 0) {
            return false;
        }
    }
    return hull.size() >= 3;
}

/// True if the body may roll without rising or sinking.
bool is_round_below(const MovingBody& body, const Vec3& up) {
    if (body.is_ball()) {
        return true;
    }
    const ConvexShape::Kind kind = body.shape->kind();
    if (kind != ConvexShape::Kind::capsule && kind != ConvexShape::Kind::cylinder) {
        return false;
    }
    return std::abs(to_world(body.state.orientation, Vec3(0, 0, 1)).dot(up)) < kLevelAxis;
}

}  // namespace

ContactsOfBodies::ContactsOfBodies(const std::vector<BodyContact>& contacts, std::size_t body_count)
    : begins_(body_count + 1, 0) {
    const auto for_each_place = [&](const auto& visit) {
        for (std::size_t i = 0; i < contacts.size(); ++i) {
            visit(static_cast<std::size_t>(contacts[i].contact.first), i);
            if (contacts[i].is_between_bodies()) {
                visit(static_cast<std::size_t>(contacts[i].contact.second), i);
            }
        }
    };
    for_each_place([&](std::size_t body, std::size_t) { ++begins_[body + 1]; });
    std::partial_sum(begins_.begin(), begins_.end(), begins_.begin());
    contacts_.resize(begins_.back());
    std::vector<std::size_t> next = begins_;
    for_each_place([&](std::size_t body, std::size_t i) { contacts_[next[body]++] = i; });
}

bool is_stably_supported(const MovingBody& body, int number, const SolvedContacts& solved,
                         std::span<const std::size_t> own, const Vec3& gravity) {
    const double strength = length(gravity);
    if (strength == 0) {
        return true;
    }
    const Vec3 up = gravity * (-1 / strength);
    const HorizontalProjection project(up);
    const Vec2 centre = project(body.state.position);
    double weight = body.mass * strength * solved.duration;  // all as impulses during the step
    Vec2 moment = centre * weight;
    double lever = 0;
    bool is_carried = false;
    std::vector<Vec2> points;
    for (const std::size_t i : own) {
        const ode::StepContact& contact = solved.contacts[i].contact;
        points.push_back(project(contact.point));
        const double rise = contact.normal.dot(up) * (contact.first == number ? 1 : -1);
        if (rise > -kLoadSlope) {
            is_carried = true;
            lever = std::max(lever, contact.rolling_arm);
        } else {
            const double load = -rise * std::max(solved.impulses[i].normal, 0.0);
            weight += load;
            moment += project(contact.point) * load;
        }
    }
    if (!is_carried) {
        return false;
    }
    const std::vector<Vec2> hull = hull_of(points);
    if (is_inside(centre, hull) || is_inside(moment / weight, hull)) {
        return true;
    }
    const double beside = distance_to_outline(centre, hull);
    return beside <= (is_round_below(body, up) ? kBesideRolling + lever : kBesideBalanced);
}

bool leans(int number, const SolvedContacts& solved, std::span<const std::size_t> own,
           const Vec3& gravity) {
    const double strength = length(gravity);
    for (const std::size_t i : own) {
        const ode::StepContact& contact = solved.contacts[i].contact;
        const double sign = contact.first == number ? 1 : -1;
        const double rise = -sign * contact.normal.dot(gravity) / strength;
        if (solved.impulses[i].normal > 0 && rise > -kLoadSlope && rise < kLevelNormal) {
            return true;
        }
    }
    return false;
}

double time_to_tip(const MovingBody& body, const Vec3& gravity) {
    constexpr double kGrowth = 34.5;  // e^34.5 = 10^15
    // The length of a rod is twice its bounding radius.
    return kGrowth * std::sqrt(4 * body.bounding_radius() / (3 * length(gravity)));
}

}  // namespace carom::sim
