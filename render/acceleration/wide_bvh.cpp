#include "render/acceleration/wide_bvh.h"

#include "render/acceleration/safe_ray.h"

namespace carom::render {

WideBvh::WideBvh(const ShapeSet& shapes, std::span<const MeshEntry> meshes,
                 const StructureOptions& options)
    : options_(options),
      planes_(infinite_shapes(shapes)),
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
        planes_.find_closest_plane(safe, best);
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
    return planes_.first_plane_hit(safe) < planes_.planes().size() ||
           shape_kernels_.any(shapes_, safe) || triangle_kernels_.any(triangles_, safe);
}

void WideBvh::find_closest_counted(const Ray& safe, RayKind kind, Hit& best) const {
    KindCounts counts;
    planes_.find_closest_plane(safe, best);
    counts.objects = planes_.planes().size();
    shape_kernels_.closest_counted(shapes_, safe, best, counts);
    triangle_kernels_.closest_counted(triangles_, safe, best, counts);
    counts_.add_ray(kind, counts);
}

bool WideBvh::find_any_counted(const Ray& safe) const {
    KindCounts counts;
    const std::size_t first = planes_.first_plane_hit(safe);
    const bool is_plane = first < planes_.planes().size();
    counts.objects = first + (is_plane ? 1 : 0);
    const bool found = is_plane || shape_kernels_.any_counted(shapes_, safe, counts) ||
                       triangle_kernels_.any_counted(triangles_, safe, counts);
    counts_.add_ray(RayKind::shadow, counts);
    return found;
}

std::size_t WideBvh::bytes() const {
    return bytes_of(shapes_.tree) + bytes_of(triangles_);
}

}  // namespace carom::render
