#include "sim/spatial/convex_contacts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "core/length.h"
#include "core/rigid.h"

namespace carom::sim {
namespace {

/// Searches for the direction along which the gap between two shapes is largest.
class Separation {
  public:
    Separation(const PlacedShape& a, const PlacedShape& b) : a_(a), b_(b) {}

    void consider(const Vec3& direction) {
        const double size = length(direction);
        if (!(size > 1e-12)) {
            return;
        }
        const Vec3 normal = direction / size;
        const double gap = gap_along(a_, b_, normal);
        // A side that is tried again, or equals another up to rounding, changes nothing.
        if (gap > gap_ + 1e-13) {
            gap_ = gap;
            normal_ = normal;
        }
    }
    void consider_sides(const PlacedShape& of, double sign) {
        const ConvexShape& shape = *of.shape;
        if (shape.kind() == ConvexShape::Kind::cylinder) {
            for (const double end : {-1.0, 1.0}) {
                consider(to_world(of.pose.orientation, Vec3(0, 0, end)));
            }
        }
        for (const PolyhedronFace& face : shape.solid().faces) {
            consider(to_world(of.pose.orientation, face.normal) * sign);
        }
    }
    /// Tries the flat sides that face the present direction most. The gap along any direction is at
    /// most the distance, so the largest gap is the best.
    void snap_to_sides() {
        const Vec3 found = normal_;
        const double gap = gap_;
        if (const auto side = a_.shape->facing_normal(to_body(a_.pose.orientation, -found))) {
            consider(-to_world(a_.pose.orientation, *side));
        }
        if (const auto side = b_.shape->facing_normal(to_body(b_.pose.orientation, found))) {
            consider(to_world(b_.pose.orientation, *side));
        }
        is_flat_ = gap_ > gap;
    }
    /// True if the normal is that of a flat side.
    [[nodiscard]] bool is_flat() const { return is_flat_; }

    /// Improves the direction by small turns: on round sides the closest points are only
    /// approximate.
    void refine() {
        constexpr double kWidest = 4e-3;  // rad
        constexpr double kFinest = 1e-6;
        constexpr int kMaxTurns = 100;
        int turns = 0;
        for (double step = kWidest; step > kFinest && turns < kMaxTurns; ++turns) {
            const double before = gap_;
            const Vec3 axis = std::abs(normal_.x) < 0.5 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
            const Vec3 u = normal_.cross(axis) / length(normal_.cross(axis));
            const Vec3 v = normal_.cross(u);
            const Vec3 from = normal_;
            for (const Vec3& turn : {u, v, -u, -v}) {
                consider(from + turn * step);
            }
            if (gap_ <= before) {
                step *= 0.5;
            }
        }
    }

    [[nodiscard]] const Vec3& normal() const { return normal_; }
    [[nodiscard]] double gap() const { return gap_; }

  private:
    const PlacedShape& a_;
    const PlacedShape& b_;
    Vec3 normal_{0, 0, 1};
    double gap_ = -1e300;
    bool is_flat_ = false;
};

FacingFeature facing_in_world(const PlacedShape& of, const Vec3& direction) {
    FacingFeature feature = of.shape->facing(to_body(of.pose.orientation, direction));
    for (Vec3& p : feature.points) {
        p = of.pose.position + to_world(of.pose.orientation, p);
    }
    feature.normal = to_world(of.pose.orientation, feature.normal);
    return feature;
}

/// Clips `points` (a point, a line or a polygon) to the prism over the flat side (Sutherland and
/// Hodgman, Reentrant polygon clipping, Comm. ACM 17, 1974).
std::vector<Vec3> clip(std::vector<Vec3> points, const FacingFeature& side) {
    const std::size_t corners = side.points.size();
    for (std::size_t e = 0; e < corners && !points.empty(); ++e) {
        const Vec3& from = side.points[e];
        const Vec3 inwards = side.normal.cross(side.points[(e + 1) % corners] - from);
        const auto height = [&](const Vec3& p) { return inwards.dot(p - from); };
        const double rim = 1e-9 * length(inwards);  // 1e-9 m: keeps a corner over a corner
        const std::size_t count = points.size();
        const std::size_t lines = count > 2 ? count : count - 1;
        std::vector<Vec3> kept;
        if (count == 1 && height(points[0]) >= -rim) {
            kept.push_back(points[0]);
        }
        for (std::size_t i = 0; i < lines; ++i) {
            const Vec3& p = points[i];
            const Vec3& q = points[(i + 1) % count];
            const double hp = height(p);
            const double hq = height(q);
            if (hp >= -rim) {
                kept.push_back(p);
            }
            if ((hp < -rim && hq > rim) || (hp > rim && hq < -rim)) {
                kept.push_back(p + (q - p) * (hp / (hp - hq)));
            }
            if (count == 2 && hq >= -rim) {
                kept.push_back(q);
            }
        }
        points = std::move(kept);
    }
    return points;
}

/// Adds the ends of the common section of two nearly parallel lines.
bool add_parallel(const FacingFeature& a, const FacingFeature& b, const Vec3& normal, double margin,
                  std::vector<Contact>& contacts) {
    constexpr double kParallel = 0.02;  // sine of the angle
    const Vec3 along_a = a.points[1] - a.points[0];
    const Vec3 along_b = b.points[1] - b.points[0];
    const double whole = length(along_a);
    if (!(whole > 0) || length(along_a.cross(along_b)) > kParallel * whole * length(along_b)) {
        return false;
    }
    const Vec3 unit = along_a / whole;
    const double b0 = unit.dot(b.points[0] - a.points[0]);
    const double b1 = unit.dot(b.points[1] - a.points[0]);
    const double low = std::max(0.0, std::min(b0, b1));
    const double high = std::min(whole, std::max(b0, b1));
    if (low > high || b0 == b1) {
        return false;
    }
    for (const double position : {low, high}) {
        const Vec3 on_a = a.points[0] + unit * position;
        const Vec3 on_b = b.points[0] + along_b * ((position - b0) / (b1 - b0));
        const double gap = normal.dot(on_a - on_b);
        if (gap <= margin) {
            contacts.push_back({(on_a + on_b) * 0.5, normal, -gap});
        }
    }
    return !contacts.empty();
}

/// Adds the points of `other` over the flat side; `sign`: +1 if the side belongs to b.
void add_over_side(const FacingFeature& side, const FacingFeature& other, const Vec3& normal,
                   double margin, double sign, std::vector<Contact>& contacts) {
    for (const Vec3& p : clip(other.points, side)) {
        const double gap = sign * normal.dot(p - side.points.front());
        if (gap <= margin) {
            contacts.push_back({p - normal * (0.5 * sign * gap), normal, -gap});
        }
    }
}

/// The closest points of the shapes; if they overlap, of cores that are as shallow as possible.
std::optional<ClosestPoints> closest_points(const PlacedShape& a, const PlacedShape& b,
                                            double far) {
    constexpr double kClear = 1e-9;  // m: for less, rounding determines the direction
    for (const double depth : {0.0, 0.1, 1.0}) {
        std::optional<ClosestPoints> closest = closest_core_points(a, b, depth, far + depth);
        if (closest && length(closest->on_a - closest->on_b) > kClear) {
            return closest;
        }
    }
    return std::nullopt;
}

Separation separation_of(const PlacedShape& a, const PlacedShape& b,
                         const std::optional<ClosestPoints>& closest, double margin) {
    Separation separation(a, b);
    if (closest) {
        separation.consider(closest->on_a - closest->on_b);
        separation.snap_to_sides();
        if (!separation.is_flat() && separation.gap() <= margin) {
            separation.refine();
        }
        return separation;
    }
    // The cores overlap, deeper than bodies in a step ever do: separate them through a side.
    separation.consider(a.pose.position - b.pose.position);
    separation.consider_sides(a, -1);
    separation.consider_sides(b, 1);
    return separation;
}

}  // namespace

/// Keeps the deepest contact (among equals the farthest from the middle), the farthest from that,
/// and the farthest from their line on either side. Of points along a line two remain.
void reduce_contacts(std::vector<Contact>& contacts) {
    if (contacts.size() <= 2) {
        return;
    }
    constexpr double kAsDeep = 1e-7;  // m
    Vec3 middle(0, 0, 0);
    double deepest = contacts.front().depth;
    for (const Contact& c : contacts) {
        middle += c.point / static_cast<double>(contacts.size());
        deepest = std::max(deepest, c.depth);
    }
    const auto largest = [&](const auto& measure) {
        return *std::max_element(
            contacts.begin(), contacts.end(),
            [&](const Contact& a, const Contact& b) { return measure(a) < measure(b) - 1e-12; });
    };
    const Contact first = largest([&](const Contact& c) {
        return c.depth > deepest - kAsDeep ? length(c.point - middle) : -1;
    });
    const Contact second = largest([&](const Contact& c) { return length(c.point - first.point); });
    const Vec3 along = second.point - first.point;
    const Vec3 aside = first.normal.cross(along);
    const auto left = [&](const Contact& c) { return aside.dot(c.point - first.point); };
    const auto right = [&](const Contact& c) { return -left(c); };
    const Contact third = largest(left);
    const Contact fourth = largest(right);
    constexpr double kSlender = 1e-3;  // of the line's length
    const double least = kSlender * along.dot(along);
    contacts = {first};
    if (left(third) > least) {
        contacts.push_back(third);
    }
    if (along.dot(along) > 0) {
        contacts.push_back(second);
    }
    if (right(fourth) > least) {
        contacts.push_back(fourth);
    }
}

void convex_contacts(const PlacedShape& a, const PlacedShape& b, double margin,
                     std::vector<Contact>& contacts) {
    contacts.clear();
    const double far = margin + a.shape->core_gap() + b.shape->core_gap();
    const std::optional<ClosestPoints> closest = closest_points(a, b, far);
    const Separation separation = separation_of(a, b, closest, margin);
    if (separation.gap() > margin) {
        return;
    }
    const Vec3& normal = separation.normal();
    const FacingFeature on_a = facing_in_world(a, -normal);
    const FacingFeature on_b = facing_in_world(b, normal);
    constexpr double kFacing = 0.9998;  // 1.1 degrees
    const double facing_a = on_a.is_flat() ? -normal.dot(on_a.normal) : 0;
    const double facing_b = on_b.is_flat() ? normal.dot(on_b.normal) : 0;
    if (facing_b >= kFacing && facing_b >= facing_a - 1e-9) {
        add_over_side(on_b, on_a, normal, margin, 1, contacts);
        return reduce_contacts(contacts);
    }
    if (facing_a >= kFacing) {
        add_over_side(on_a, on_b, normal, margin, -1, contacts);
        return reduce_contacts(contacts);
    }
    if (on_a.points.size() == 2 && on_b.points.size() == 2 &&
        add_parallel(on_a, on_b, normal, margin, contacts)) {
        return;
    }
    Vec3 point = a.support(-normal);
    if (closest) {
        point = (closest->on_a + closest->on_b) * 0.5;
    }
    const double middle = 0.5 * normal.dot(a.support(-normal) + b.support(normal));
    contacts.push_back({point + normal * (middle - normal.dot(point)), normal, -separation.gap()});
}

}  // namespace carom::sim
