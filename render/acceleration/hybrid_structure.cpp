#include "render/acceleration/hybrid_structure.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <iterator>
#include <utility>

#include "render/acceleration/moving_shape.h"
#include "render/acceleration/safe_ray.h"
#include "render/acceleration/triangle_batch_kernels.h"
#include "render/acceleration/triangle_scene.h"

namespace carom::render {
namespace {

/// Bound for a search below t_max that must also find a hit at `t` itself, for the tie rule.
float just_beyond(float t) {
    return std::nextafter(t, kInfinity);
}

constexpr int kBatch = 64;  // rays

RayBatch part_of(const RayBatch& rays, int first) {
    RayBatch part = rays;
    part.count = std::min(kBatch, rays.count - first);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        part.origin[axis] += first;
        part.direction[axis] += first;
    }
    part.time += first;
    return part;
}

}  // namespace

HybridStructure::HybridStructure(const ShapeSet& shapes, std::size_t tree_threshold)
    : HybridStructure(ShapeSet{}, nullptr) {
    instances_ = make_instance_tree(shapes.instances);
    meshes_ = shapes.meshes;
    if (loop_cost(shapes) >= tree_threshold) {
        tree_ = std::make_shared<const AnalyticTree>(make_analytic_tree(shapes));
        set_loops(infinite_shapes(shapes));
    } else {
        set_loops(shapes);
    }
}

HybridStructure::HybridStructure(const ShapeSet& shapes,
                                 std::shared_ptr<const AnalyticTree> static_tree)
    : kernels_(best_kernels()),
      batch_kernels_(best_batch_kernels()),
      tree_kernels_(best_tree_kernels()),
      instance_kernels_(best_instance_batch_kernels()),
      tree_(std::move(static_tree)),
      instances_(make_instance_tree(shapes.instances)),
      meshes_(shapes.meshes) {
    set_loops(shapes);
}

void HybridStructure::set_loops(const ShapeSet& shapes) {
    loops_ = make_loop_blocks(shapes.blocks);
    moving_ = make_moving_loops(shapes.moving);
}

std::size_t HybridStructure::bytes() const {
    return (tree_ ? bytes_of(tree_->tree) : 0) + bytes_of(instances_) +
           (meshes_ ? meshes_->bytes() : 0);
}

bool HybridStructure::closest_hit(const Ray& ray, Hit& hit) const {
    if (!is_traceable(ray)) {
        return false;
    }
    Ray remaining = made_safe(ray);
    Hit best;
    best.t = remaining.t_max;
    if (tree_) {
        tree_kernels_.closest(*tree_, remaining, best);
        remaining.t_max = best.object != kNoObject ? just_beyond(best.t) : best.t;
    }
    Candidate analytic{remaining.t_max, kNoObject};
    kernels_.closest(loops_.blocks, remaining, analytic);
    const bool is_tie = analytic.t == best.t && analytic.object < best.object;
    if (analytic.object != kNoObject &&
        (best.object == kNoObject || analytic.t < best.t || is_tie)) {
        best = {analytic.t, analytic.object, 0, 0, 0};
        remaining.t_max = just_beyond(best.t);
    }
    if (!find_outside_tree(remaining, best)) {
        return false;
    }
    hit = best;
    return true;
}

// Continues after loops and tree have found `best`, or nothing; `remaining` ends just beyond it.
bool HybridStructure::find_outside_tree(Ray remaining, Hit& best) const {
    const auto accept = [&](const Hit& other) {
        const bool is_tie = other.t == best.t && other.object < best.object;
        if (best.object == kNoObject || other.t < best.t || is_tie) {
            best = other;
            remaining.t_max = just_beyond(best.t);
        }
    };
    for (const MovingShape& shape : moving_.shapes) {
        Hit other;
        if (intersect_moving(shape, remaining, other)) {
            accept(other);
        }
    }
    Hit other;
    if (instance_kernels_.closest_of_ray(instances_, remaining, other)) {
        accept(other);
    }
    if (meshes_ && meshes_->closest_hit(remaining, other)) {
        accept(other);
    }
    return best.object != kNoObject;
}

bool HybridStructure::any_hit(const Ray& ray) const {
    if (!is_traceable(ray)) {
        return false;
    }
    const Ray safe = made_safe(ray);
    if (tree_ && tree_kernels_.any(*tree_, safe)) {
        return true;
    }
    if (kernels_.any(loops_.blocks, safe)) {
        return true;
    }
    for (const MovingShape& shape : moving_.shapes) {
        if (occluded_by_moving(shape, safe)) {
            return true;
        }
    }
    return instance_kernels_.any_of_ray(instances_, safe) || (meshes_ && meshes_->any_hit(safe));
}

/// The nearest hits of a part of a batch.
struct HybridStructure::PartHits {
    float t[kBatch + RayBatch::kBeyond];
    std::int32_t object[kBatch + RayBatch::kBeyond];
    std::int32_t primitive[kBatch + RayBatch::kBeyond];
    float u[kBatch + RayBatch::kBeyond];
    float v[kBatch + RayBatch::kBeyond];

    PartHits() {
        std::fill(std::begin(t), std::end(t), kInfinity);
        std::fill(std::begin(object), std::end(object), -1);
        std::fill(std::begin(primitive), std::end(primitive), 0);
        std::fill(std::begin(u), std::end(u), 0.f);
        std::fill(std::begin(v), std::end(v), 0.f);
    }

    [[nodiscard]] Hit hit(int i) const {
        return {t[i], static_cast<std::uint32_t>(object[i]),
                static_cast<std::uint32_t>(primitive[i]), u[i], v[i]};
    }
    void set(int i, const Hit& hit) {
        t[i] = hit.t;
        object[i] = static_cast<std::int32_t>(hit.object);
        primitive[i] = static_cast<std::int32_t>(hit.primitive);
        u[i] = hit.u;
        v[i] = hit.v;
    }
    /// Takes a hit that is nearer, or equally near and of a lower object.
    void offer(int i, const Hit& other) {
        const bool is_tie = other.t == t[i] && static_cast<std::int32_t>(other.object) < object[i];
        if (other.t < t[i] || is_tie) {
            set(i, other);
        }
    }
};

void HybridStructure::closest_hits(const RayBatch& rays, Hit* hits) const {
    for (int first = 0; first < rays.count; first += kBatch) {
        const RayBatch part = part_of(rays, first);
        PartHits best;
        batch_kernels_.closest(loops_, part, best.t, best.object);
        for (int i = 0; i < part.count && tree_; ++i) {
            const Ray ray = part.ray(i, best.t[i]);
            if (is_traceable(ray)) {
                Hit hit = best.hit(i);
                tree_kernels_.closest(*tree_, made_safe(ray), hit);
                best.set(i, hit);
            }
        }
        each_meeting(part, best.t, [&](const MovingShape& shape, std::uint64_t rays_of_shape) {
            find_moving(shape, part, rays_of_shape, best);
        });
        const HitArrays nearest{best.t, best.object, best.primitive, best.u, best.v};
        instance_kernels_.closest(instances_, part, nearest);
        if (meshes_) {
            meshes_->closest_hits(part, nearest);
        }
        for (int i = 0; i < part.count; ++i) {
            hits[first + i] = best.hit(i);
        }
    }
}

namespace {

/// The numbers of the rays that a mask names, and where they hit a shape.
struct NamedRays {
    std::int32_t numbers[kBatch + RayBatch::kBeyond];
    float distances[kBatch + RayBatch::kBeyond];
    int count = 0;

    NamedRays(std::uint64_t rays, const MovingShape& shape, const RayBatch& batch,
              const BatchKernels& kernels) {
        for (; rays != 0; rays &= rays - 1) {
            numbers[count++] = std::countr_zero(rays);
        }
        std::fill_n(numbers + count, RayBatch::kBeyond, numbers[0]);
        kernels.hit_moving(shape, batch, numbers, count, distances);
    }
};

}  // namespace

void HybridStructure::find_moving(const MovingShape& shape, const RayBatch& part,
                                  std::uint64_t rays_of_shape, PartHits& best) const {
    const NamedRays rays(rays_of_shape, shape, part, batch_kernels_);
    for (int k = 0; k < rays.count; ++k) {
        best.offer(rays.numbers[k], {rays.distances[k], shape.object, 0, 0, 0});
    }
}

void HybridStructure::occlude_by_moving(const MovingShape& shape, const RayBatch& part,
                                        std::uint64_t rays_of_shape, float* t) const {
    const NamedRays rays(rays_of_shape, shape, part, batch_kernels_);
    for (int k = 0; k < rays.count; ++k) {
        const int i = rays.numbers[k];
        t[i] = rays.distances[k] < t[i] ? 0 : t[i];
    }
}

/// Calls `visit(i, rays)` for each of the boxes that rays of a part of a batch may meet at up to
/// t[i], with a bit for each of these rays.
template <class Visit>
void HybridStructure::each_that_meets(std::span<const Imath::Box3f> boxes, const RayBatch& part,
                                      const float* t, const Visit& visit) const {
    constexpr std::size_t kTogether = 16;
    std::uint64_t rays[kTogether];
    for (std::size_t first = 0; first < boxes.size(); first += kTogether) {
        const auto some = boxes.subspan(first, std::min(kTogether, boxes.size() - first));
        batch_kernels_.meet_boxes(some, part, t, rays);
        for (std::size_t k = 0; k < some.size(); ++k) {
            if (rays[k] != 0) {
                visit(first + k, rays[k]);
            }
        }
    }
}

/// Calls `visit(shape, rays)` for each moving shape that rays of a part of a batch may hit at up to
/// t[i], with a bit for each of these rays and perhaps for a few more.
template <class Visit>
void HybridStructure::each_meeting(const RayBatch& part, const float* t, const Visit& visit) const {
    each_that_meets(moving_.body_boxes, part, t, [&](std::size_t i, std::uint64_t rays) {
        const MovingLoops::Body& body = moving_.bodies[i];
        if (body.count == 1) {
            visit(moving_.shapes[body.first], rays);
        } else {
            each_that_meets(moving_.boxes_of(body), part, t,
                            [&](std::size_t k, std::uint64_t some) {
                                visit(moving_.shapes[body.first + k], some);
                            });
        }
    });
}

void HybridStructure::test_occlusion(const RayBatch& rays, float* t_max) const {
    batch_kernels_.occlude(loops_, rays, t_max);
    for (int i = 0; i < rays.count && tree_; ++i) {
        const Ray ray = rays.ray(i, t_max[i]);
        if (t_max[i] > 0 && is_traceable(ray) && tree_kernels_.any(*tree_, made_safe(ray))) {
            t_max[i] = 0;
        }
    }
    for (int first = 0; first < rays.count && !moving_.shapes.empty(); first += kBatch) {
        const RayBatch part = part_of(rays, first);
        float* part_t = t_max + first;
        each_meeting(part, part_t, [&](const MovingShape& shape, std::uint64_t rays_of_shape) {
            occlude_by_moving(shape, part, rays_of_shape, part_t);
        });
    }
    instance_kernels_.occlude(instances_, rays, t_max);
    if (meshes_) {
        meshes_->test_occlusion(rays, t_max);
    }
}

}  // namespace carom::render
