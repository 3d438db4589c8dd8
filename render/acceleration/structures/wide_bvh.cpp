#include "render/acceleration/structures/wide_bvh.h"

#include <algorithm>

#include "render/acceleration/safe_ray.h"
#include "render/acceleration/structures/query.h"

namespace carom::render {

WideBvh::WideBvh(const ShapeSet& shapes, std::span<const MeshEntry> meshes,
                 const StructureOptions& options)
    : options_(options),
      planes_(infinite_planes(shapes)),
      shapes_(make_analytic_tree(shapes)),
      triangles_(make_triangle_tree(meshes)),
      shape_kernels_(best_tree_kernels()),
      triangle_kernels_(best_triangle_kernels()) {}

bool WideBvh::closest_hit(const Ray& ray, Hit& hit) const {
    const Hit best = find_closest(ray, ray.kind);
    if (best.object == kNoObject) {
        return false;
    }
    hit = best;
    return true;
}

Hit WideBvh::find_closest(const Ray& ray, RayKind kind) const {
    if (!is_traceable(ray)) {
        return {};
    }
    const Ray safe = made_safe(ray);
    KindCounts counts;
    if (!options_.counts) {
        Hit best = nearest_plane<false>(safe, counts);
        shape_kernels_.closest(shapes_, safe, best);
        triangle_kernels_.closest(triangles_, safe, best);
        return best;
    }
    Hit best = nearest_plane<true>(safe, counts);
    shape_kernels_.closest_counted(shapes_, safe, best, counts);
    triangle_kernels_.closest_counted(triangles_, safe, best, counts);
    counts_.add_ray(kind, counts);
    return best;
}

bool WideBvh::any_hit(const Ray& ray) const {
    if (!options_.shadow_rays_stop) {
        return find_closest(ray, RayKind::shadow).object != kNoObject;
    }
    if (!is_traceable(ray)) {
        return false;
    }
    const Ray safe = made_safe(ray);
    KindCounts counts;
    if (!options_.counts) {
        return meets_plane<false>(safe, counts) || shape_kernels_.any(shapes_, safe) ||
               triangle_kernels_.any(triangles_, safe);
    }
    const bool found = meets_plane<true>(safe, counts) ||
                       shape_kernels_.any_counted(shapes_, safe, counts) ||
                       triangle_kernels_.any_counted(triangles_, safe, counts);
    counts_.add_ray(RayKind::shadow, counts);
    return found;
}

template <bool Counting>
Hit WideBvh::nearest_plane(const Ray& safe, KindCounts& counts) const {
    Hit best;
    best.t = safe.t_max;
    if (!planes_.planes().empty()) {
        Query<Counting> planes(planes_, safe, false);
        for (const Primitive& plane : planes_.planes()) {
            static_cast<void>(planes.test(plane));
        }
        counts += planes.counts();
        best = planes.best();
    }
    return best;
}

template <bool Counting>
bool WideBvh::meets_plane(const Ray& safe, KindCounts& counts) const {
    if (planes_.planes().empty()) {
        return false;
    }
    Query<Counting> planes(planes_, safe, true);
    const bool found = std::ranges::any_of(
        planes_.planes(), [&](const Primitive& plane) { return planes.test(plane); });
    counts += planes.counts();
    return found;
}

std::size_t WideBvh::bytes() const {
    return bytes_of(shapes_.tree) + bytes_of(triangles_);
}

}  // namespace carom::render
