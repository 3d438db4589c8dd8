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
    if (!is_traceable(ray)) {
        return false;
    }
    const Ray safe = made_safe(ray);
    Hit best;
    best.t = safe.t_max;
    if (options_.counts) {
        find_closest_counted(safe, ray.kind, best);
    } else {
        find_closest_plane<false>(safe, best);
        shape_kernels_.closest(shapes_, safe, best);
        triangle_kernels_.closest(triangles_, safe, best);
    }
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
    if (!options_.shadow_rays_stop) {
        Ray searching = safe;
        searching.kind = RayKind::shadow;
        Hit hit;
        return closest_hit(searching, hit);
    }
    if (options_.counts) {
        return find_any_counted(safe);
    }
    return find_any_plane<false>(safe).found || shape_kernels_.any(shapes_, safe) ||
           triangle_kernels_.any(triangles_, safe);
}

void WideBvh::find_closest_counted(const Ray& safe, RayKind kind, Hit& best) const {
    KindCounts counts = find_closest_plane<true>(safe, best);
    shape_kernels_.closest_counted(shapes_, safe, best, counts);
    triangle_kernels_.closest_counted(triangles_, safe, best, counts);
    counts_.add_ray(kind, counts);
}

bool WideBvh::find_any_counted(const Ray& safe) const {
    auto [found, counts] = find_any_plane<true>(safe);
    found = found || shape_kernels_.any_counted(shapes_, safe, counts) ||
            triangle_kernels_.any_counted(triangles_, safe, counts);
    counts_.add_ray(RayKind::shadow, counts);
    return found;
}

template <bool Counting>
KindCounts WideBvh::find_closest_plane(const Ray& safe, Hit& best) const {
    if (planes_.planes().empty()) {
        return {};
    }
    Query<Counting> planes(planes_, safe, false);
    for (const Primitive& plane : planes_.planes()) {
        static_cast<void>(planes.test(plane));
    }
    best = planes.best();
    return planes.counts();
}

template <bool Counting>
WideBvh::FoundAny WideBvh::find_any_plane(const Ray& safe) const {
    if (planes_.planes().empty()) {
        return {};
    }
    Query<Counting> planes(planes_, safe, true);
    const bool found = std::ranges::any_of(
        planes_.planes(), [&](const Primitive& plane) { return planes.test(plane); });
    return {found, planes.counts()};
}

std::size_t WideBvh::bytes() const {
    return bytes_of(shapes_.tree) + bytes_of(triangles_);
}

}  // namespace carom::render
