#include "render/acceleration/primitives.h"

#include <algorithm>
#include <array>

#include "core/assert.h"
#include "render/acceleration/moving_shape.h"
#include "render/triangle/moller_trumbore.h"

namespace carom::render {

using Kind = Primitive::Kind;

namespace {

/// Whether an analytic shape is met nearer than `t`, which is then replaced.
bool meets(const AnalyticKernels& kernels, const AnalyticBlocks& blocks, const Primitive& shape,
           const Ray& ray, float& t) {
    const std::uint32_t block = shape.index / kBlockLanes;
    const int lane = static_cast<int>(shape.index % kBlockLanes);
    switch (shape.kind) {
        case Kind::still_sphere:
            return kernels.still_sphere(blocks.still_spheres[block], lane, ray, t);
        case Kind::moving_sphere:
            return kernels.moving_sphere(blocks.moving_spheres[block], lane, ray, t);
        case Kind::box:
            return kernels.box(blocks.boxes[block], lane, ray, t);
        case Kind::mapped_ball:
            return kernels.mapped_ball(blocks.mapped_balls[block], lane, ray, t);
        case Kind::mapped_box:
            return kernels.mapped_box(blocks.mapped_boxes[block], lane, ray, t);
        case Kind::rectangle:
            return kernels.rectangle(blocks.rectangles[block], lane, ray, t);
        case Kind::triangle:
            return kernels.triangle(blocks.triangles[block], lane, ray, t);
        case Kind::disk:
            return kernels.disk(blocks.disks[block], lane, ray, t);
        case Kind::frustum:
            return kernels.frustum(blocks.frustums[block], lane, ray, t);
        case Kind::plane:
            return kernels.plane(blocks.planes[block], lane, ray, t);
        case Kind::moving:
        case Kind::mesh_triangle:
            break;
    }
    return false;
}

}  // namespace

/// Pairs each shape with its lane; the blocks hold the same shapes in the same (stable) order.
template <class Block, class Shape, class Bounds>
void Primitives::add(Kind kind, const std::vector<Block>& blocks, const std::vector<Shape>& shapes,
                     const Bounds& bounds) {
    std::uint32_t i = 0;
    for (const Shape& shape : in_object_order(shapes)) {
        CAROM_ASSERT(blocks[i / kBlockLanes].object.values[i % kBlockLanes] ==
                     static_cast<std::int32_t>(shape.object));
        (kind == Kind::plane ? planes_ : bounded_)
            .push_back({kind, i, shape.object, 0, bounds(shape)});
        ++i;
    }
    static_cast<void>(blocks);
}

Primitives::Primitives(const ShapeSet& shapes, std::span<const MeshEntry> meshes)
    : kernels_(&best_kernels()), blocks_(make_blocks(shapes)), moving_(shapes.moving) {
    const SpheresByMotion spheres = by_motion(shapes.spheres);
    const auto round = [](const SphereStretch& sphere) { return bounds_of(sphere); };
    add(Kind::still_sphere, blocks_.still_spheres, spheres.still, round);
    add(Kind::moving_sphere, blocks_.moving_spheres, spheres.moving, round);
    add(Kind::box, blocks_.boxes, shapes.boxes,
        [](const AlignedBox& box) { return bounds_of(box); });
    const auto solid = [](const MappedShape& shape) { return bounds_of(shape, false); };
    const auto flat = [](const MappedShape& shape) { return bounds_of(shape, true); };
    add(Kind::mapped_ball, blocks_.mapped_balls, shapes.mapped_balls, solid);
    add(Kind::mapped_box, blocks_.mapped_boxes, shapes.mapped_boxes, solid);
    add(Kind::rectangle, blocks_.rectangles, shapes.rectangles, flat);
    add(Kind::triangle, blocks_.triangles, shapes.triangles, flat);
    add(Kind::disk, blocks_.disks, shapes.disks, flat);
    add(Kind::frustum, blocks_.frustums, shapes.frustums, solid);
    add(Kind::plane, blocks_.planes, shapes.planes,
        [](const MappedShape& /*shape*/) { return MovingBounds(); });
    for (std::uint32_t i = 0; i < moving_.size(); ++i) {
        const MovingShape& shape = moving_[i];
        if (shape.kind == MovingShape::Kind::plane) {
            planes_.push_back({Kind::moving, i, shape.object, 0, {}});
        } else {
            bounded_.push_back({Kind::moving, i, shape.object, 0, bounds_of(shape)});
        }
    }
    add_meshes(meshes);
}

void Primitives::add_meshes(std::span<const MeshEntry> meshes) {
    for (std::uint32_t mesh = 0; mesh < meshes.size(); ++mesh) {
        meshes_.push_back(meshes[mesh].mesh);
        const auto count = static_cast<std::uint32_t>(meshes[mesh].mesh->triangles.size());
        for (std::uint32_t number = 0; number < count; ++number) {
            Primitive triangle{Kind::mesh_triangle, mesh, meshes[mesh].object, number, {}};
            const auto corners_of = corners(triangle);
            triangle.bounds = bounds_of(corners_of);
            bounded_.push_back(triangle);
        }
    }
}

std::array<V3f, 3> Primitives::corners(const Primitive& triangle) const {
    const TriangleMesh& mesh = *meshes_[triangle.index];
    const auto& corner = mesh.triangles[triangle.number];
    return {mesh.vertices[corner[0]], mesh.vertices[corner[1]], mesh.vertices[corner[2]]};
}

bool Primitives::closest(const Primitive& shape, const Ray& ray, Hit& hit) const {
    if (shape.kind == Kind::moving) {
        return intersect_moving(moving_[shape.index], ray, hit);
    }
    if (shape.kind == Kind::mesh_triangle) {
        const auto [a, b, c] = corners(shape);
        const auto met = moller_trumbore(ray, a, b, c);
        if (met) {
            hit = {met->t, shape.object, shape.number, met->u, met->v};
        }
        return met.has_value();
    }
    float t = ray.t_max;
    const bool found = meets(*kernels_, blocks_, shape, ray, t);
    if (found) {
        hit = {t, shape.object, 0, 0, 0};
    }
    return found;
}

void Primitives::find_closest_plane(const Ray& ray, Hit& best) const {
    for (const Primitive& plane : planes_) {
        Hit other;
        if (!closest(plane, ray, other)) {
            continue;
        }
        const bool is_tie = other.t == best.t && other.object < best.object;
        if (other.t < best.t || (is_tie && best.object != kNoObject)) {
            best = other;
        }
    }
}

std::size_t Primitives::first_plane_met(const Ray& ray) const {
    const auto met = std::ranges::find_if(planes_, [&](const Primitive& plane) {
        Hit hit;
        return closest(plane, ray, hit);
    });
    return static_cast<std::size_t>(met - planes_.begin());
}

}  // namespace carom::render
