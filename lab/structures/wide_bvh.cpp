#include "lab/structures/wide_bvh.h"

#include "lab/structures/counted_trees.h"
#include "lab/structures/primitives.h"
#include "lab/structures/test_counts.h"
#include "render/acceleration/safe_ray.h"

namespace carom::render {

struct WideBvh::Counted {
    Counted(const ShapeSet& all, std::span<const MeshEntry> meshes)
        : planes(infinite_shapes(all)),
          shapes(make_analytic_tree(all)),
          instances(make_instance_tree(all.instances)),
          triangles(make_triangle_tree(meshes)) {}

    Primitives planes;
    AnalyticTree shapes;
    InstanceTree instances;
    TriangleTree triangles;

    void closest(const Ray& safe, Hit& best, KindCounts& counts) const {
        planes.find_closest_plane(safe, best);
        counts.objects = planes.planes().size();
        closest_counted(shapes, safe, best, counts);
        closest_counted(instances, safe, best, counts);
        closest_counted(triangles, safe, best, counts);
    }
    [[nodiscard]] bool any(const Ray& safe, KindCounts& counts) const {
        const std::size_t first = planes.first_plane_hit(safe);
        const bool is_plane = first < planes.planes().size();
        counts.objects = first + (is_plane ? 1 : 0);
        return is_plane || any_counted(shapes, safe, counts) ||
               any_counted(instances, safe, counts) || any_counted(triangles, safe, counts);
    }
};

WideBvh::WideBvh(const ShapeSet& shapes, std::span<const MeshEntry> meshes,
                 const StructureOptions& options)
    : options_(options),
      trees_(shapes, 0),
      counted_(options.counts != nullptr ? std::make_unique<Counted>(shapes, meshes) : nullptr) {}

WideBvh::~WideBvh() = default;

bool WideBvh::closest_hit(const Ray& ray, Hit& hit) const {
    if (!counted_) {
        return trees_.closest_hit(ray, hit);
    }
    if (!is_traceable(ray)) {
        return false;
    }
    const Ray safe = made_safe(ray);
    Hit best;
    best.t = safe.t_max;
    KindCounts counts;
    counted_->closest(safe, best, counts);
    options_.counts->add_ray(ray.kind, counts);
    if (best.object == kNoObject) {
        return false;
    }
    hit = best;
    return true;
}

bool WideBvh::any_hit(const Ray& ray) const {
    if (!options_.shadow_rays_stop) {
        Ray searching = ray;
        searching.kind = RayKind::shadow;
        Hit hit;
        return closest_hit(searching, hit);
    }
    if (!counted_) {
        return trees_.any_hit(ray);
    }
    if (!is_traceable(ray)) {
        return false;
    }
    KindCounts counts;
    const bool found = counted_->any(made_safe(ray), counts);
    options_.counts->add_ray(RayKind::shadow, counts);
    return found;
}

}  // namespace carom::render
