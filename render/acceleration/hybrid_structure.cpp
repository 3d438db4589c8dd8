#include "render/acceleration/hybrid_structure.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <iterator>
#include <utility>

#include "render/acceleration/moving_shape.h"
#include "render/acceleration/safe_ray.h"
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
      tree_(std::move(static_tree)),
      meshes_(shapes.meshes) {
    set_loops(shapes);
}

void HybridStructure::set_loops(const ShapeSet& shapes) {
    blocks_ = shapes.blocks;
    moving_ = shapes.moving;
}

std::size_t HybridStructure::bytes() const {
    return (tree_ ? bytes_of(tree_->tree) : 0) + (meshes_ ? meshes_->bytes() : 0);
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
    kernels_.closest(blocks_, remaining, analytic);
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
    for (const MovingShape& shape : moving_) {
        Hit other;
        if (intersect_moving(shape, remaining, other)) {
            accept(other);
        }
    }
    Hit other;
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
    if (kernels_.any(blocks_, safe)) {
        return true;
    }
    for (const MovingShape& shape : moving_) {
        if (occluded_by_moving(shape, safe)) {
            return true;
        }
    }
    return meshes_ && meshes_->any_hit(safe);
}

namespace {

/// The nearest hits of a part of a batch.
struct PartHits {
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

}  // namespace

void HybridStructure::closest_hits(const RayBatch& rays, Hit* hits) const {
    for (int first = 0; first < rays.count; first += kBatch) {
        const RayBatch part = part_of(rays, first);
        PartHits best;
        batch_kernels_.closest(blocks_, part, best.t, best.object);
        for (int i = 0; i < part.count && tree_; ++i) {
            const Ray ray = part.ray(i, best.t[i]);
            if (is_traceable(ray)) {
                Hit hit = best.hit(i);
                tree_kernels_.closest(*tree_, made_safe(ray), hit);
                best.set(i, hit);
            }
        }
        for (const MovingShape& shape : moving_) {
            for (std::uint64_t left = may_meet(shape, part, best.t); left != 0; left &= left - 1) {
                const int i = std::countr_zero(left);
                const Ray ray = part.ray(i, just_beyond(best.t[i]));
                Hit other;
                if (is_traceable(ray) && intersect_moving(shape, ray, other)) {
                    best.offer(i, other);
                }
            }
        }
        if (meshes_) {
            meshes_->closest_hits(part, {best.t, best.object, best.primitive, best.u, best.v});
        }
        for (int i = 0; i < part.count; ++i) {
            hits[first + i] = best.hit(i);
        }
    }
}

/// The rays of a part of a batch that may hit the shape at up to t[i], and perhaps more.
std::uint64_t HybridStructure::may_meet(const MovingShape& shape, const RayBatch& part,
                                        const float* t) const {
    if (shape.is_infinite()) {
        return part.count == kBatch ? ~std::uint64_t{0} : (std::uint64_t{1} << part.count) - 1;
    }
    return batch_kernels_.meet_box(shape.bounds, part, t);
}

void HybridStructure::test_occlusion(const RayBatch& rays, float* t_max) const {
    batch_kernels_.occlude(blocks_, rays, t_max);
    for (int i = 0; i < rays.count && tree_; ++i) {
        const Ray ray = rays.ray(i, t_max[i]);
        if (t_max[i] > 0 && is_traceable(ray) && tree_kernels_.any(*tree_, made_safe(ray))) {
            t_max[i] = 0;
        }
    }
    for (int first = 0; first < rays.count && !moving_.empty(); first += kBatch) {
        const RayBatch part = part_of(rays, first);
        float* part_t = t_max + first;
        for (const MovingShape& shape : moving_) {
            for (std::uint64_t left = may_meet(shape, part, part_t); left != 0; left &= left - 1) {
                const int i = std::countr_zero(left);
                const Ray ray = part.ray(i, part_t[i]);
                if (is_traceable(ray) && occluded_by_moving(shape, ray)) {
                    part_t[i] = 0;
                }
            }
        }
    }
    if (meshes_) {
        meshes_->test_occlusion(rays, t_max);
    }
}

}  // namespace carom::render
