#include "sim/spatial/convex_distance.h"

#include <array>
#include <cmath>
#include <cstddef>

#include "core/rigid.h"

namespace carom::sim {
namespace {

/// A point of the Minkowski difference a - b, with the points of a and b that define it.
struct Vertex {
    Vec3 difference{0, 0, 0};
    Vec3 on_a{0, 0, 0};
    Vec3 on_b{0, 0, 0};
    double weight = 1;
};

/// Up to four vertices whose weighted sum is the point nearest to the origin.
struct Simplex {
    std::array<Vertex, 4> vertices;
    std::size_t count = 0;

    [[nodiscard]] Vec3 nearest() const {
        Vec3 sum(0, 0, 0);
        for (std::size_t i = 0; i < count; ++i) {
            sum += vertices[i].difference * vertices[i].weight;
        }
        return sum;
    }
};

/// The vertices whose bits are set.
Simplex subset(const Simplex& from, unsigned bits) {
    Simplex result;
    for (std::size_t i = 0; i < from.count; ++i) {
        if ((bits >> i & 1U) != 0) {
            result.vertices[result.count++] = from.vertices[i];
        }
    }
    return result;
}

/// Computes the weights of the point nearest to the origin on the line or plane through the
/// vertices; false if that point lies outside of the vertices or they are degenerate.
bool compute_weights(Simplex& s) {
    const Vec3& p = s.vertices[0].difference;
    if (s.count == 1) {
        s.vertices[0].weight = 1;
        return true;
    }
    const Vec3 u = s.vertices[1].difference - p;
    if (s.count == 2) {
        const double uu = u.dot(u);
        const double t = uu > 0 ? -p.dot(u) / uu : -1;
        s.vertices[0].weight = 1 - t;
        s.vertices[1].weight = t;
        return t >= 0 && t <= 1;
    }
    const Vec3 v = s.vertices[2].difference - p;
    const double uu = u.dot(u);
    const double uv = u.dot(v);
    const double vv = v.dot(v);
    const double determinant = uu * vv - uv * uv;
    if (!(determinant > 1e-14 * uu * vv)) {
        return false;
    }
    const double pu = -p.dot(u);
    const double pv = -p.dot(v);
    const double a = (vv * pu - uv * pv) / determinant;
    const double b = (uu * pv - uv * pu) / determinant;
    s.vertices[0].weight = 1 - a - b;
    s.vertices[1].weight = a;
    s.vertices[2].weight = b;
    return a >= 0 && b >= 0 && a + b <= 1;
}

/// True if the origin lies inside the tetrahedron.
bool contains_origin(const Simplex& s) {
    const auto side = [&](std::size_t i, std::size_t j, std::size_t k, const Vec3& x) {
        const Vec3& p = s.vertices[i].difference;
        const Vec3 n = (s.vertices[j].difference - p).cross(s.vertices[k].difference - p);
        return n.dot(x - p);
    };
    const auto same = [&](std::size_t i, std::size_t j, std::size_t k, std::size_t l) {
        const double corner = side(i, j, k, s.vertices[l].difference);
        const double origin = side(i, j, k, Vec3(0, 0, 0));
        return corner * origin > 0;
    };
    return same(0, 1, 2, 3) && same(0, 1, 3, 2) && same(0, 2, 3, 1) && same(1, 2, 3, 0);
}

/// Keeps only the vertices that the nearest point needs. False if the origin is inside.
bool reduce(Simplex& s) {
    if (s.count == 4 && contains_origin(s)) {
        return false;
    }
    // Corners, edges and triangles, each as the bits of its vertices.
    constexpr std::array<unsigned, 14> kParts{1, 2, 4, 8, 3, 5, 9, 6, 10, 12, 7, 11, 13, 14};
    Simplex best;
    double least = 1e300;
    for (const unsigned part : kParts) {
        if (part >= 1U << s.count) {
            continue;
        }
        Simplex candidate = subset(s, part);
        if (!compute_weights(candidate)) {
            continue;
        }
        const Vec3 nearest = candidate.nearest();
        if (nearest.dot(nearest) < least) {
            least = nearest.dot(nearest);
            best = candidate;
        }
    }
    s = best;
    return true;
}

}  // namespace

Vec3 PlacedShape::support(const Vec3& world_direction) const {
    return pose.position +
           to_world(pose.orientation, shape->support(to_body(pose.orientation, world_direction)));
}

Vec3 PlacedShape::core_support(const Vec3& world_direction, double depth) const {
    const Vec3 local = to_body(pose.orientation, world_direction);
    return pose.position + to_world(pose.orientation, shape->core_support(local, depth));
}

std::optional<ClosestPoints> closest_core_points(const PlacedShape& a, const PlacedShape& b,
                                                 double depth, double far) {
    constexpr int kMaxIterations = 100;
    constexpr double kConverged = 1e-13;      // relative, of the squared distance
    constexpr double kZeroDistance2 = 1e-18;  // m^2
    Vec3 nearest = a.pose.position - b.pose.position;
    if (nearest.dot(nearest) < kZeroDistance2) {
        nearest = {0, 0, 1};
    }
    Simplex simplex;
    for (int i = 0; i < kMaxIterations; ++i) {
        Vertex next;
        next.on_a = a.core_support(-nearest, depth);
        next.on_b = b.core_support(nearest, depth);
        next.difference = next.on_a - next.on_b;
        const double square = nearest.dot(nearest);
        // A plane with this normal separates the cores by at least `least` / |nearest|.
        const double least = nearest.dot(next.difference);
        if (simplex.count > 0 && least > 0 && least * least > far * far * square) {
            break;
        }
        if (simplex.count > 0 && square - nearest.dot(next.difference) <= kConverged * square) {
            break;
        }
        const Simplex before = simplex;
        simplex.vertices[simplex.count++] = next;
        if (!reduce(simplex)) {
            return std::nullopt;
        }
        const Vec3 closer = simplex.nearest();
        if (closer.dot(closer) < kZeroDistance2) {
            return std::nullopt;
        }
        // Rounding prevents further progress.
        if (before.count > 0 && closer.dot(closer) >= square) {
            simplex = before;
            break;
        }
        nearest = closer;
    }
    ClosestPoints result;
    for (std::size_t i = 0; i < simplex.count; ++i) {
        result.on_a += simplex.vertices[i].on_a * simplex.vertices[i].weight;
        result.on_b += simplex.vertices[i].on_b * simplex.vertices[i].weight;
    }
    return result;
}

double gap_along(const PlacedShape& a, const PlacedShape& b, const Vec3& normal) {
    return normal.dot(a.support(-normal) - b.support(normal));
}

}  // namespace carom::sim
