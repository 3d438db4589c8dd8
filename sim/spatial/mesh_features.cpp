#include "sim/spatial/mesh_features.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace carom::sim {
namespace {

// Vertices this close (m) are one.
constexpr double kWeld = 1e-7;
// A neighbouring triangle whose far corner is out of the plane by less than this share of its
// distance lies in it.
constexpr double kFlat = 1e-6;

using Triangle = std::array<std::uint32_t, 3>;
using Edge = std::pair<std::uint32_t, std::uint32_t>;

/// Gives equal places one number.
class Welder {
  public:
    std::uint32_t number_of(const Vec3& p) {
        const std::array<std::int64_t, 3> cell{std::llround(p.x / kWeld), std::llround(p.y / kWeld),
                                               std::llround(p.z / kWeld)};
        const auto [found, is_new] =
            numbers_.try_emplace(cell, static_cast<std::uint32_t>(places_.size()));
        if (is_new)
            places_.push_back(p);
        return found->second;
    }
    [[nodiscard]] const Vec3& place(std::uint32_t number) const { return places_[number]; }

  private:
    std::map<std::array<std::int64_t, 3>, std::uint32_t> numbers_;
    std::vector<Vec3> places_;
};

struct EdgeUse {
    int count = 0;
    std::uint32_t opposite = 0;  // the third corner of the first triangle seen
    Vec3 normal{0, 0, 0};        // its normal
    bool is_flat = false;        // two triangles in one plane meet here
};

double length(const Vec3& v) { return std::sqrt(v.dot(v)); }

class Builder {
  public:
    Builder(std::uint32_t surface, std::vector<MeshFeature>& features)
        : surface_(surface), features_(features) {}

    void add_face(const Vec3& a, const Vec3& b, const Vec3& c) {
        const Triangle t{welder_.number_of(a), welder_.number_of(b), welder_.number_of(c)};
        const Vec3 normal = (b - a).cross(c - a);
        const double area = length(normal);
        if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0] || area < 1e-14)
            return;
        MeshFeature face;
        face.kind = MeshFeature::Kind::face;
        face.surface = surface_;
        face.points = {welder_.place(t[0]), welder_.place(t[1]), welder_.place(t[2])};
        face.direction = normal / area;
        features_.push_back(face);
        for (std::size_t i = 0; i < 3; ++i)
            use_edge(t[i], t[(i + 1) % 3], t[(i + 2) % 3], face.direction);
    }

    void finish() {
        std::set<std::uint32_t> corners;
        for (const auto& [edge, use] : edges_) {
            if (use.count == 2 && use.is_flat)
                continue;
            MeshFeature feature;
            feature.kind = MeshFeature::Kind::edge;
            feature.surface = surface_;
            feature.points = {welder_.place(edge.first), welder_.place(edge.second), Vec3(0, 0, 0)};
            const Vec3 along = feature.points[1] - feature.points[0];
            feature.direction = along / length(along);
            features_.push_back(feature);
            corners.insert(edge.first);
            corners.insert(edge.second);
        }
        for (const std::uint32_t corner : corners) {
            MeshFeature feature;
            feature.kind = MeshFeature::Kind::corner;
            feature.surface = surface_;
            feature.points[0] = welder_.place(corner);
            features_.push_back(feature);
        }
    }

  private:
    void use_edge(std::uint32_t a, std::uint32_t b, std::uint32_t opposite, const Vec3& normal) {
        EdgeUse& use = edges_[std::minmax(a, b)];
        if (++use.count == 1) {
            use.opposite = opposite;
            use.normal = normal;
        } else if (use.count == 2) {
            const Vec3 to_far = welder_.place(opposite) - welder_.place(a);
            use.is_flat = std::abs(use.normal.dot(to_far)) < kFlat * length(to_far) &&
                          use.normal.dot(normal) > 0;
        }
    }

    std::uint32_t surface_;
    std::vector<MeshFeature>& features_;
    Welder welder_;
    std::map<Edge, EdgeUse> edges_;
};

/// Ericson, Real-Time Collision Detection, 2005, section 5.1.5: the nearest point by the Voronoi
/// region of the triangle that `p` lies in.
Vec3 nearest_on_triangle(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) {
    const Vec3 ab = b - a;
    const Vec3 ac = c - a;
    const Vec3 ap = p - a;
    const double d1 = ab.dot(ap);
    const double d2 = ac.dot(ap);
    if (d1 <= 0 && d2 <= 0)
        return a;
    const Vec3 bp = p - b;
    const double d3 = ab.dot(bp);
    const double d4 = ac.dot(bp);
    if (d3 >= 0 && d4 <= d3)
        return b;
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0)
        return a + ab * (d1 / (d1 - d3));
    const Vec3 cp = p - c;
    const double d5 = ab.dot(cp);
    const double d6 = ac.dot(cp);
    if (d6 >= 0 && d5 <= d6)
        return c;
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0)
        return a + ac * (d2 / (d2 - d6));
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0)
        return b + (c - b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6)));
    const double whole = va + vb + vc;
    return a + ab * (vb / whole) + ac * (vc / whole);
}

}  // namespace

void MeshFeatures::add(const std::vector<Vec3>& vertices, const std::vector<Triangle>& triangles,
                       std::uint32_t surface) {
    Builder builder(surface, features_);
    for (const Triangle& t : triangles)
        builder.add_face(vertices[t[0]], vertices[t[1]], vertices[t[2]]);
    builder.finish();
}

Vec3 nearest_point(const MeshFeature& feature, const Vec3& point) {
    const auto& p = feature.points;
    switch (feature.kind) {
        case MeshFeature::Kind::face:
            return nearest_on_triangle(p[0], p[1], p[2], point);
        case MeshFeature::Kind::edge: {
            const Vec3 along = p[1] - p[0];
            const double place = (point - p[0]).dot(along) / along.dot(along);
            return p[0] + along * std::clamp(place, 0.0, 1.0);
        }
        case MeshFeature::Kind::corner:
            break;
    }
    return p[0];
}

}  // namespace carom::sim
