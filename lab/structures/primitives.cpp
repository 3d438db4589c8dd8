#include "lab/structures/primitives.h"

#include <algorithm>
#include <array>

#include "render/acceleration/moving_shape.h"
#include "render/acceleration/triangle_batch_kernels.h"
#include "render/triangle/moller_trumbore.h"

namespace carom::render {

template <class Shape>
void Primitives::add(const BlockList<Shape>& list) {
    for (std::uint32_t i = 0; i < list.size; ++i) {
        if constexpr (Shape::kIsBounded) {
            bounded_.push_back({kLaneShape<Shape>, i, list.object(i), 0, bounds_of(list, i)});
        } else {
            planes_.push_back({kLaneShape<Shape>, i, list.object(i), 0, {}});
        }
    }
}

Primitives::Primitives(const ShapeSet& shapes, std::span<const MeshEntry> meshes,
                       const TriangleTestMaker& triangle_test)
    : kernels_(&best_kernels()), blocks_(shapes.blocks), moving_(shapes.moving) {
    blocks_.each([&](const auto& list) { add(list); });
    for (std::uint32_t i = 0; i < moving_.size(); ++i) {
        const MovingShape& shape = moving_[i];
        if (shape.is_infinite()) {
            planes_.push_back({Primitive::kMoving, i, shape.object, 0, {}});
        } else {
            bounded_.push_back({Primitive::kMoving, i, shape.object, 0, bounds_of(shape)});
        }
    }
    for (const MeshInstance& instance : shapes.instances) {
        const auto index = static_cast<std::uint32_t>(instances_.size());
        bounded_.push_back({Primitive::kInstance, index, instance.object, 0,
                            MovingBounds{instance.bounds, instance.bounds}});
        instances_.push_back(make_instance_tree({instance}));
    }
    const std::size_t first = bounded_.size();
    add_meshes(meshes);
    if (triangle_test) {
        std::vector<std::array<V3f, 3>> triangles;
        for (std::size_t i = first; i < bounded_.size(); ++i) {
            triangles.push_back(corners(bounded_[i]));
        }
        triangle_test_ = triangle_test(triangles);
    }
}

void Primitives::add_meshes(std::span<const MeshEntry> meshes) {
    for (std::uint32_t mesh = 0; mesh < meshes.size(); ++mesh) {
        first_triangle_.push_back(
            meshes_.empty() ? 0 : first_triangle_.back() + meshes_.back()->triangles.size());
        meshes_.push_back(meshes[mesh].mesh);
        const auto count = static_cast<std::uint32_t>(meshes[mesh].mesh->triangles.size());
        for (std::uint32_t number = 0; number < count; ++number) {
            Primitive triangle{Primitive::kMeshTriangle, mesh, meshes[mesh].object, number, {}};
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
    if (shape.shape == Primitive::kMoving) {
        return intersect_moving(moving_[shape.index], ray, hit);
    }
    if (shape.shape == Primitive::kInstance) {
        return best_instance_batch_kernels().closest_of_ray(instances_[shape.index], ray, hit);
    }
    if (shape.shape == Primitive::kMeshTriangle && triangle_test_) {
        const bool is_hit =
            triangle_test_->closest(first_triangle_[shape.index] + shape.number, ray, hit);
        if (is_hit) {
            hit.object = shape.object;
            hit.primitive = shape.number;
        }
        return is_hit;
    }
    if (shape.shape == Primitive::kMeshTriangle) {
        const auto [a, b, c] = corners(shape);
        const auto found = triangle_hit(ray, a, b, c);
        if (found) {
            hit = {found->t, shape.object, shape.number, found->u, found->v};
        }
        return found.has_value();
    }
    float t = ray.t_max;
    const bool found = kernels_->one(blocks_, shape.shape, shape.index, ray, t);
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

std::size_t Primitives::first_plane_hit(const Ray& ray) const {
    const auto first = std::ranges::find_if(planes_, [&](const Primitive& plane) {
        Hit hit;
        return closest(plane, ray, hit);
    });
    return static_cast<std::size_t>(first - planes_.begin());
}

}  // namespace carom::render
