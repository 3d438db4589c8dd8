#include "sim/spatial/mesh_features.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "core/length.h"

namespace carom::sim {
namespace {

// Vertices this close (m) are merged.
constexpr double kWeld = 1e-7;
// A neighbouring triangle lies in the same plane if its far corner is out of the plane by less than
// this fraction of its distance.
constexpr double kFlat = 1e-6;

/// Assigns one number to equal positions.
class Welder {
  public:
    explicit Welder(std::size_t count) {
        numbers_.reserve(count);
        positions_.reserve(count);
    }
    std::uint32_t number_of(const Vec3& p) {
        const Cell cell{std::llround(p.x / kWeld), std::llround(p.y / kWeld),
                        std::llround(p.z / kWeld)};
        const auto [found, is_new] =
            numbers_.try_emplace(cell, static_cast<std::uint32_t>(positions_.size()));
        if (is_new) {
            positions_.push_back(p);
        }
        return found->second;
    }
    [[nodiscard]] const Vec3& position(std::uint32_t number) const { return positions_[number]; }
    [[nodiscard]] std::size_t size() const { return positions_.size(); }

  private:
    using Cell = std::array<std::int64_t, 3>;
    struct CellHash {
        std::size_t operator()(const Cell& cell) const {
            std::uint64_t hash = 0;
            for (const std::int64_t c : cell) {
                hash = (hash ^ static_cast<std::uint64_t>(c)) * 0x9E3779B97F4A7C15U;
            }
            return hash ^ (hash >> 32);
        }
    };
    std::unordered_map<Cell, std::uint32_t, CellHash> numbers_;  // never iterated
    std::vector<Vec3> positions_;
};

/// The use of an edge by one triangle; after sorting, the uses of an edge are adjacent.
struct EdgeUse {
    std::uint32_t from = 0, to = 0;  // from < to
    std::uint32_t face = 0;
    std::uint32_t opposite = 0;  // the triangle's third corner

    friend bool operator<(const EdgeUse& a, const EdgeUse& b) {
        return std::tie(a.from, a.to, a.face) < std::tie(b.from, b.to, b.face);
    }
};

class Builder {
  public:
    explicit Builder(std::size_t triangle_count) : welder_(triangle_count) {
        uses_.reserve(3 * triangle_count);
        features_.reserve(2 * triangle_count);
    }

    void add_face(const Vec3& a, const Vec3& b, const Vec3& c) {
        const MeshTriangle t{welder_.number_of(a), welder_.number_of(b), welder_.number_of(c)};
        const Vec3 normal = (b - a).cross(c - a);
        const double area = length(normal);
        if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0] || area < 1e-14) {
            return;
        }
        MeshFeature face;
        face.kind = MeshFeature::Kind::face;
        face.points = {welder_.position(t[0]), welder_.position(t[1]), welder_.position(t[2])};
        face.direction = normal / area;
        const auto number = static_cast<std::uint32_t>(features_.size());
        for (std::size_t i = 0; i < 3; ++i) {
            const auto [low, high] = std::minmax(t[i], t[(i + 1) % 3]);
            uses_.push_back({low, high, number, t[(i + 2) % 3]});
        }
        features_.push_back(face);
    }

    [[nodiscard]] std::vector<MeshFeature> finish() && {
        std::sort(uses_.begin(), uses_.end());
        is_corner_.assign(welder_.size(), 0);
        for (std::size_t begin = 0; begin < uses_.size();) {
            std::size_t end = begin + 1;
            while (end < uses_.size() && uses_[end].from == uses_[begin].from &&
                   uses_[end].to == uses_[begin].to) {
                ++end;
            }
            if (end - begin != 2 || !is_flat(uses_[begin], uses_[begin + 1])) {
                add_edge(uses_[begin]);
            }
            begin = end;
        }
        for (std::uint32_t i = 0; i < is_corner_.size(); ++i) {
            if (is_corner_[i] == 0) {
                continue;
            }
            MeshFeature feature;
            feature.kind = MeshFeature::Kind::corner;
            feature.points[0] = welder_.position(i);
            features_.push_back(feature);
        }
        return std::move(features_);
    }

  private:
    [[nodiscard]] bool is_flat(const EdgeUse& a, const EdgeUse& b) const {
        const Vec3 to_far = welder_.position(b.opposite) - welder_.position(b.from);
        const Vec3& normal = features_[a.face].direction;
        return std::abs(normal.dot(to_far)) < kFlat * length(to_far) &&
               std::abs(normal.dot(features_[b.face].direction)) > 0.5 && !is_folded(a, b);
    }

    /// True if both triangles lie on the same side of their edge, one on top of the other.
    [[nodiscard]] bool is_folded(const EdgeUse& a, const EdgeUse& b) const {
        const Vec3& from = welder_.position(a.from);
        const Vec3 along = welder_.position(a.to) - from;
        const Vec3 side_a = along.cross(welder_.position(a.opposite) - from);
        const Vec3 side_b = along.cross(welder_.position(b.opposite) - from);
        return side_a.dot(side_b) > 0;
    }

    void add_edge(const EdgeUse& use) {
        MeshFeature feature;
        feature.kind = MeshFeature::Kind::edge;
        feature.points = {welder_.position(use.from), welder_.position(use.to), Vec3(0, 0, 0)};
        const Vec3 along = feature.points[1] - feature.points[0];
        feature.direction = along / length(along);
        features_.push_back(feature);
        is_corner_[use.from] = is_corner_[use.to] = 1;
    }

    std::vector<MeshFeature> features_;
    Welder welder_;
    std::vector<EdgeUse> uses_;
    std::vector<char> is_corner_;
};

/// The nearest point by the Voronoi region of the triangle that contains `p` (Ericson, Real-Time
/// Collision Detection, 2005, section 5.1.5).
Vec3 nearest_on_triangle(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) {
    const Vec3 ab = b - a;
    const Vec3 ac = c - a;
    const Vec3 ap = p - a;
    const double d1 = ab.dot(ap);
    const double d2 = ac.dot(ap);
    if (d1 <= 0 && d2 <= 0) {
        return a;
    }
    const Vec3 bp = p - b;
    const double d3 = ab.dot(bp);
    const double d4 = ac.dot(bp);
    if (d3 >= 0 && d4 <= d3) {
        return b;
    }
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) {
        return a + ab * (d1 / (d1 - d3));
    }
    const Vec3 cp = p - c;
    const double d5 = ab.dot(cp);
    const double d6 = ac.dot(cp);
    if (d6 >= 0 && d5 <= d6) {
        return c;
    }
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0) {
        return a + ac * (d2 / (d2 - d6));
    }
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
        return b + (c - b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6)));
    }
    const double whole = va + vb + vc;
    return a + ab * (vb / whole) + ac * (vc / whole);
}

}  // namespace

std::vector<MeshFeature> mesh_features(const std::vector<Vec3>& vertices,
                                       const std::vector<MeshTriangle>& triangles) {
    Builder builder(triangles.size());
    for (const MeshTriangle& t : triangles) {
        builder.add_face(vertices[t[0]], vertices[t[1]], vertices[t[2]]);
    }
    return std::move(builder).finish();
}

Vec3 nearest_point(const MeshFeature& feature, const Vec3& point) {
    const auto& p = feature.points;
    switch (feature.kind) {
        case MeshFeature::Kind::face:
            return nearest_on_triangle(p[0], p[1], p[2], point);
        case MeshFeature::Kind::edge: {
            const Vec3 along = p[1] - p[0];
            const double fraction = (point - p[0]).dot(along) / along.dot(along);
            return p[0] + along * std::clamp(fraction, 0.0, 1.0);
        }
        case MeshFeature::Kind::corner:
            break;
    }
    return p[0];
}

}  // namespace carom::sim
