#include "render/acceleration/structures/wide_bvh.h"

#include <algorithm>

#include "render/acceleration/safe_ray.h"
#include "render/acceleration/structures/query.h"

namespace carom::render {

WideBvh::WideBvh(const ShapeSet& shapes, std::span<const MeshEntry> meshes)
    : planes_(infinite_planes(shapes)),
      shapes_(make_analytic_tree(shapes)),
      triangles_(make_triangle_tree(meshes)),
      shape_kernels_(best_tree_kernels()),
      triangle_kernels_(best_triangle_kernels()) {}

bool WideBvh::closest_hit(const Ray& ray, Hit& hit) const {
    if (!is_traceable(ray)) {
        return false;
    }
    const Ray safe = made_safe(ray);
    Hit best;
    best.t = safe.t_max;
    if (!planes_.planes().empty()) {
        Query<false> planes(planes_, safe, false);
        for (const Primitive& plane : planes_.planes()) {
            static_cast<void>(planes.test(plane));
        }
        best = planes.best();
    }
    if (!shapes_.tree.nodes.empty()) {
        shape_kernels_.closest(shapes_, safe, best);
    }
    triangle_kernels_.closest(triangles_, safe, best);
    if (best.object == kNoObject) {
        return false;
    }
    hit = best;
    return true;
}

bool WideBvh::any_hit(const Ray& ray) const {
    if (!is_traceable(ray)) {
        return false;
    }
    const Ray safe = made_safe(ray);
    return meets_plane(safe) || shape_kernels_.any(shapes_, safe) ||
           triangle_kernels_.any(triangles_, safe);
}

bool WideBvh::meets_plane(const Ray& safe) const {
    if (planes_.planes().empty()) {
        return false;
    }
    Query<false> planes(planes_, safe, true);
    return std::ranges::any_of(planes_.planes(),
                               [&](const Primitive& plane) { return planes.test(plane); });
}

std::size_t WideBvh::bytes() const {
    return bytes_of(shapes_.tree) + bytes_of(triangles_);
}

}  // namespace carom::render
