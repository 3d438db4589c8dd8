#include "render/geometry/smooth_normals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "core/elementary.h"
#include "core/elementary_float.h"

namespace carom::render {
namespace {

/// Numbers the vertices by position, from 0 without gaps.
std::vector<std::uint32_t> number_places(const std::vector<V3f>& vertices) {
    std::vector<std::uint32_t> order(vertices.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto key = [&](std::uint32_t i) {
        return std::tie(vertices[i].x, vertices[i].y, vertices[i].z);
    };
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
    std::vector<std::uint32_t> place(vertices.size());
    std::uint32_t count = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
        count += i > 0 && key(order[i - 1]) != key(order[i]) ? 1 : 0;
        place[order[i]] = count;
    }
    return place;
}

struct Corner {
    V3f normal{0, 0, 0};  // of its triangle, unit
    float angle = 0;      // rad
};

std::vector<Corner> make_corners(const TriangleMesh& mesh) {
    std::vector<Corner> corners;
    corners.reserve(3 * mesh.triangles.size());
    for (const auto& triangle : mesh.triangles) {
        std::array<V3f, 3> p;
        for (std::size_t k = 0; k < 3; ++k) {
            p[k] = mesh.vertices[triangle[k]];
        }
        const V3f normal = (p[1] - p[0]).cross(p[2] - p[0]).normalized();
        for (std::size_t k = 0; k < 3; ++k) {
            const V3f to_next = p[(k + 1) % 3] - p[k];
            const V3f to_last = p[(k + 2) % 3] - p[k];
            const float angle = arctangent2(to_next.cross(to_last).length(), to_next.dot(to_last));
            corners.push_back({normal, angle});
        }
    }
    return corners;
}

/// Corners grouped by position: those of position i are from first[i] to first[i + 1].
struct CornersByPlace {
    std::vector<std::uint32_t> first;
    std::vector<std::uint32_t> corners;
};

CornersByPlace sort_corners(const TriangleMesh& mesh, const std::vector<std::uint32_t>& place) {
    CornersByPlace result;
    result.first.assign(mesh.vertices.size() + 1, 0);
    for (const auto& triangle : mesh.triangles) {
        for (const std::uint32_t vertex : triangle) {
            ++result.first[place[vertex] + 1];
        }
    }
    std::partial_sum(result.first.begin(), result.first.end(), result.first.begin());
    result.corners.resize(3 * mesh.triangles.size());
    std::vector<std::uint32_t> next = result.first;
    for (std::uint32_t corner = 0; corner < result.corners.size(); ++corner) {
        result.corners[next[place[mesh.triangles[corner / 3][corner % 3]]]++] = corner;
    }
    return result;
}

/// Vertices of the new mesh: one per old vertex and normal.
class Splitter {
  public:
    explicit Splitter(const TriangleMesh& mesh)
        : mesh_(mesh), newest_(mesh.vertices.size(), kNone) {}

    std::uint32_t vertex(std::uint32_t old, const V3f& normal) {
        for (std::uint32_t i = newest_[old]; i != kNone; i = older_[i]) {
            if (split.normals[i] == normal) {
                return i;
            }
        }
        const auto index = static_cast<std::uint32_t>(split.vertices.size());
        split.vertices.push_back(mesh_.vertices[old]);
        split.normals.push_back(normal);
        if (!mesh_.uv.empty()) {
            split.uv.push_back(mesh_.uv[old]);
        }
        older_.push_back(newest_[old]);
        newest_[old] = index;
        return index;
    }

    TriangleMesh split;

  private:
    static constexpr std::uint32_t kNone = 0xffffffffu;
    const TriangleMesh& mesh_;
    std::vector<std::uint32_t> newest_;  // by old vertex: the last new vertex made from it
    std::vector<std::uint32_t> older_;   // by new vertex: the previous one from the same old vertex
};

/// Up to so many corners at one position each is compared with each. It bounds the time for files
/// with millions of triangles at one point.
constexpr std::uint32_t kManyCorners = 2'048;

/// Sums of the normals at a position with many corners, by direction: a bin for each square of a
/// grid on the six sides of a cube, which is at most 13 degrees wide.
class DirectionBins {
  public:
    DirectionBins() { bins_.fill(V3f(0, 0, 0)); }

    void add(const Corner& corner) { bins_[bin_of(corner.normal)] += corner.angle * corner.normal; }

    /// The sum over all bins whose mean direction is within the crease of that of a normal's bin.
    [[nodiscard]] V3f sum_around(const V3f& normal, float least_cosine) const {
        const std::size_t own = bin_of(normal);
        V3f sum = bins_[own];
        const V3f direction = sum.normalized();
        for (std::size_t i = 0; i < bins_.size(); ++i) {
            if (i != own && bins_[i].normalized().dot(direction) >= least_cosine) {
                sum += bins_[i];
            }
        }
        return sum;
    }

    [[nodiscard]] static std::size_t bin_of(const V3f& normal) {
        int axis = 0;
        for (int k = 1; k < 3; ++k) {
            axis = std::abs(normal[k]) > std::abs(normal[axis]) ? k : axis;
        }
        const float size = std::abs(normal[axis]);
        const auto cell = [&](int k) {
            const float place = size > 0 ? (normal[k] / size + 1) / 2 : 0.f;
            return std::min(static_cast<std::size_t>(place * kCells), kCells - 1);
        };
        const std::size_t side = 2 * static_cast<std::size_t>(axis) + (normal[axis] < 0 ? 1 : 0);
        return (side * kCells + cell((axis + 1) % 3)) * kCells + cell((axis + 2) % 3);
    }

    static constexpr std::size_t kCells = 8;
    static constexpr std::size_t kCount = 6 * kCells * kCells;

  private:
    std::array<V3f, kCount> bins_;
};

/// New normals of the corners at one position with many of them.
void smooth_many(std::span<const std::uint32_t> corners_here, const std::vector<Corner>& corners,
                 float least_cosine, std::vector<V3f>& normals) {
    DirectionBins bins;
    for (const std::uint32_t corner : corners_here) {
        bins.add(corners[corner]);
    }
    std::array<std::optional<V3f>, DirectionBins::kCount> known;
    for (const std::uint32_t corner : corners_here) {
        std::optional<V3f>& normal = known[DirectionBins::bin_of(corners[corner].normal)];
        if (!normal) {
            normal = bins.sum_around(corners[corner].normal, least_cosine).normalized();
        }
        normals[corner] = *normal;
    }
}

/// New normals of the corners at one position.
void smooth_few(std::span<const std::uint32_t> corners_here, const std::vector<Corner>& corners,
                float least_cosine, std::vector<V3f>& normals) {
    for (const std::uint32_t corner : corners_here) {
        V3f sum(0, 0, 0);
        for (const std::uint32_t i : corners_here) {
            if (i / 3 == corner / 3 ||
                corners[i].normal.dot(corners[corner].normal) >= least_cosine) {
                sum += corners[i].angle * corners[i].normal;
            }
        }
        normals[corner] = sum.normalized();
    }
}

}  // namespace

void smooth_normals(TriangleMesh& mesh, double crease) {
    const std::vector<std::uint32_t> place = number_places(mesh.vertices);
    const std::vector<Corner> corners = make_corners(mesh);
    const CornersByPlace around = sort_corners(mesh, place);
    const float least_cosine = static_cast<float>(cosine(crease));
    std::vector<V3f> normals(corners.size());
    for (std::size_t i = 0; i + 1 < around.first.size(); ++i) {
        const auto here = std::span(around.corners)
                              .subspan(around.first[i], around.first[i + 1] - around.first[i]);
        const auto smooth = here.size() > kManyCorners ? smooth_many : smooth_few;
        smooth(here, corners, least_cosine, normals);
    }
    Splitter splitter(mesh);
    for (std::uint32_t corner = 0; corner < corners.size(); ++corner) {
        if (corner % 3 == 0) {
            splitter.split.triangles.emplace_back();
        }
        splitter.split.triangles.back()[corner % 3] =
            splitter.vertex(mesh.triangles[corner / 3][corner % 3], normals[corner]);
    }
    mesh = std::move(splitter.split);
}

}  // namespace carom::render
