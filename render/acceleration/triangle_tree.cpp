#include "render/acceleration/triangle_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "render/geometry/ray.h"
#include "render/threads/thread_arena.h"

namespace carom::render {
namespace {

/// By how much slabs are widened for the rounding of distances, as a fraction
/// of the coordinates: an eighth of the distance at which rays start off their
/// surface.
constexpr float kSlabMargin = kOffsetFraction / 8;

/// The rounding of the distance of a hit, as a fraction of coordinates, for a
/// triangle with a right angle.
constexpr float kHitRounding = 0x1p-20f;

/// By how much a triangle's angle at its first corner enlarges that. Triangles
/// without area are never hit.
float enlargement(const V3f& edge_b, const V3f& edge_c) {
    const float area = (edge_b % edge_c).length();
    return area > 0 ? edge_b.length() * edge_c.length() / area : 1.f;
}

/// The sum of the sizes of coordinates.
float size_of(const V3f& v) {
    return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
}

using Corners = std::array<V3f, 3>;

bool has_area(const Corners& corners) {
    const Vec3 a(corners[0]);
    return (Vec3(corners[1]) - a).cross(Vec3(corners[2]) - a) != Vec3(0, 0, 0);
}

/// The slab of a leaf's triangles, along the mean of their normals.
LeafSlab slab_of(std::span<const Corners> triangles) {
    V3f sum(0, 0, 0);
    for (const auto& [a, b, c] : triangles) {
        const V3f normal = (b - a) % (c - a);
        sum += sum.dot(normal) < 0 ? -normal : normal;
    }
    LeafSlab slab{sum.length() > 0 ? sum.normalized() : V3f(0, 0, 1),
                  kInfinity,
                  -kInfinity,
                  0,
                  kHitRounding,
                  0};
    for (const Corners& corners : triangles) {
        const V3f edge_b = corners[1] - corners[0];
        const V3f edge_c = corners[2] - corners[0];
        slab.rounding = std::max(slab.rounding, kHitRounding * enlargement(edge_b, edge_c));
        slab.edge = std::max({slab.edge, size_of(edge_b), size_of(edge_c)});
        for (const V3f& corner : corners) {
            const float height = slab.normal.dot(corner);
            slab.low = std::min(slab.low, height);
            slab.high = std::max(slab.high, height);
            slab.size =
                std::max({slab.size, std::abs(corner.x), std::abs(corner.y), std::abs(corner.z)});
        }
    }
    slab.low -= kSlabMargin * slab.size;
    slab.high += kSlabMargin * slab.size;
    return slab;
}

struct Place {
    std::uint32_t mesh, number;
};

V3f corner_of(std::span<const MeshEntry> meshes, const Place& place, std::size_t k) {
    const TriangleMesh& mesh = *meshes[place.mesh].mesh;
    return mesh.vertices[mesh.triangles[place.number][k]];
}

/// How many triangles may have the same box without being looked at more
/// closely: a leaf's.
constexpr std::size_t kFewEqual = kBlockLanes;

/// Removes triangles that have exactly the corners of an earlier one of the
/// same mesh, if there are many: every ray that meets the first one would be
/// tested against all. None of them is ever seen, because of hits at the same
/// distance the first counts. Returns whether some were removed. `order` is the
/// tree's, in which triangles with the same box are neighbours.
bool remove_repeated(std::span<const MeshEntry> meshes, std::span<const std::uint32_t> order,
                     std::vector<Place>& places, std::vector<MovingBounds>& bounds) {
    const auto key = [&](std::uint32_t item) {
        std::array<float, 10> numbers{static_cast<float>(places[item].mesh)};
        for (std::size_t k = 0; k < 9; ++k) {
            numbers[k + 1] = corner_of(meshes, places[item], k / 3)[static_cast<int>(k % 3)];
        }
        return numbers;
    };
    std::vector<bool> is_repeated(places.size(), false);
    bool any = false;
    for (std::size_t first = 0, end = 0; first < order.size(); first = end) {
        while (end < order.size() && bounds[order[end]].open == bounds[order[first]].open) {
            ++end;
        }
        if (end - first <= kFewEqual) {
            continue;
        }
        std::vector<std::uint32_t> equal(order.begin() + static_cast<std::ptrdiff_t>(first),
                                         order.begin() + static_cast<std::ptrdiff_t>(end));
        std::sort(equal.begin(), equal.end(), [&](std::uint32_t a, std::uint32_t b) {
            const auto key_of_a = key(a);
            const auto key_of_b = key(b);
            return key_of_a != key_of_b ? key_of_a < key_of_b : a < b;
        });
        for (std::size_t i = 1; i < equal.size(); ++i) {
            is_repeated[equal[i]] = key(equal[i]) == key(equal[i - 1]);
            any = any || is_repeated[equal[i]];
        }
    }
    std::size_t kept = 0;
    for (std::size_t i = 0; any && i < places.size(); ++i) {
        if (!is_repeated[i]) {
            places[kept] = places[i];
            bounds[kept] = bounds[i];
            ++kept;
        }
    }
    if (any) {
        places.resize(kept);
        bounds.resize(kept);
    }
    return any;
}

constexpr std::size_t kLeavesTogether = 1024;  // that a thread fills

void fill_leaf(std::span<const MeshEntry> meshes, const std::vector<Place>& places,
               std::size_t index, TriangleTree& tree) {
    const WideLeaf& leaf = tree.tree.leaves[index];
    TriangleBlock& block = tree.blocks[index];
    for (FloatLanes(&axes)[3] : block.corners) {
        for (FloatLanes& lanes : axes) {
            std::fill_n(lanes.values, kBlockLanes, std::numeric_limits<float>::quiet_NaN());
        }
    }
    std::array<Corners, kBlockLanes> triangles;
    for (std::uint32_t lane = 0; lane < leaf.count; ++lane) {
        const Place& place = places[tree.tree.order[leaf.first + lane]];
        Corners& corners = triangles[lane];
        for (std::size_t k = 0; k < 3; ++k) {
            corners[k] = corner_of(meshes, place, k);
        }
        for (std::size_t k = 0; k < 3 && has_area(corners); ++k) {
            for (int axis = 0; axis < 3; ++axis) {
                block.corners[k][axis].values[lane] = corners[k][axis];
            }
        }
        TriangleNames& names = tree.names[index];
        names.object.values[lane] = static_cast<std::int32_t>(meshes[place.mesh].object);
        names.number.values[lane] = static_cast<std::int32_t>(place.number);
    }
    tree.slabs[index] = slab_of(std::span(triangles).first(leaf.count));
}

}  // namespace

TriangleTree make_triangle_tree(std::span<const MeshEntry> meshes) {
    std::vector<Place> places;
    std::vector<MovingBounds> bounds;
    const auto corner = [&](const Place& place, std::size_t k) {
        return corner_of(meshes, place, k);
    };
    for (std::uint32_t mesh = 0; mesh < meshes.size(); ++mesh) {
        const auto count = static_cast<std::uint32_t>(meshes[mesh].mesh->triangles.size());
        for (std::uint32_t number = 0; number < count; ++number) {
            const Place place{mesh, number};
            places.push_back(place);
            const std::array<V3f, 3> corners = {corner(place, 0), corner(place, 1),
                                                corner(place, 2)};
            bounds.push_back(bounds_of(corners));
        }
    }
    TriangleTree result;
    for (const MovingBounds& one : bounds) {
        result.bounds.extendBy(one.open);
    }
    result.tree = build_wide_tree(bounds);
    if (remove_repeated(meshes, result.tree.order, places, bounds)) {
        result.tree = build_wide_tree(bounds);
    }
    bounds = {};
    const std::size_t leaves = result.tree.leaves.size();
    result.slabs.resize(leaves);
    result.blocks.resize(leaves);
    result.names.resize(leaves);
    parallel_for((leaves + kLeavesTogether - 1) / kLeavesTogether, [&](std::size_t part) {
        const std::size_t end = std::min(leaves, (part + 1) * kLeavesTogether);
        for (std::size_t i = part * kLeavesTogether; i < end; ++i) {
            fill_leaf(meshes, places, i, result);
        }
    });
    return result;
}

std::size_t bytes_of(const TriangleTree& tree) {
    return bytes_of(tree.tree) +
           tree.blocks.size() * (sizeof(TriangleBlock) + sizeof(TriangleNames) + sizeof(LeafSlab));
}

}  // namespace carom::render
