// One ray's search: its nearest hit, its current t_max, and the number of tests.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "lab/structures/primitives.h"
#include "lab/structures/test_counts.h"
#include "render/geometry/scalar_kernels.h"

namespace carom::render {

/// `Counting`: whether tests are counted; if not, counting costs nothing.
template <bool Counting>
class Query {
  public:
    /// `ray` is safe (safe_ray.h). `any`: the first hit found ends the search.
    Query(const Primitives& primitives, const Ray& ray, bool any)
        : primitives_(primitives), ray_(ray), any_(any) {
        best_.t = ray.t_max;
        // As in kernels/box_lines.h, boxes are widened by a fraction of the origin's coordinates.
        constexpr float kMarginFraction = 0x1p-18f;
        const V3f& o = ray.origin;
        const float margin = kMarginFraction * (std::abs(o.x) + std::abs(o.y) + std::abs(o.z));
        slack_ = static_cast<double>(margin);
        for (int axis = 0; axis < 3; ++axis) {
            const float reciprocal = scalar::finite_reciprocal<scalar::One>(ray.direction[axis]);
            const float apart = std::copysign(margin, ray.direction[axis]);
            inverse_[axis] = reciprocal;
            near_origin_[axis] = (o[axis] + apart) * reciprocal;
            far_origin_[axis] = (o[axis] - apart) * reciprocal;
            near_side_[static_cast<std::size_t>(axis)] = std::signbit(ray.direction[axis]) ? 1 : 0;
        }
    }

    [[nodiscard]] const Ray& ray() const { return ray_; }
    /// What begins beyond this distance need not be visited.
    [[nodiscard]] float t_max() const { return best_.t; }
    [[nodiscard]] const Hit& best() const { return best_; }
    [[nodiscard]] bool found() const { return best_.object != kNoObject; }
    [[nodiscard]] const KindCounts& counts() const { return counts_; }

    void note_node() {
        if constexpr (Counting) {
            counts_.nodes += 1;
        }
    }
    void note_boxes(std::uint64_t number) {
        if constexpr (Counting) {
            counts_.boxes += number;
        }
    }

    /// Whether nothing from the distance `t` on matters, with a margin for the rounding of hits.
    [[nodiscard]] bool is_beyond(double t) const {
        return t * (1 - 0x1p-18) - slack_ > static_cast<double>(best_.t);
    }

    /// Whether the ray enters the box before t_max; if so, `enter` is the distance.
    [[nodiscard]] bool enters(const Imath::Box3f& box, float& enter) {
        note_boxes(1);
        float leave = best_.t;
        enter = ray_.t_min;
        for (int axis = 0; axis < 3; ++axis) {
            const bool down = near_side_[static_cast<std::size_t>(axis)] != 0;
            const float near = (down ? box.max : box.min)[axis];
            const float far = (down ? box.min : box.max)[axis];
            enter = std::max(enter, near * inverse_[axis] - near_origin_[axis]);
            leave = std::min(leave, far * inverse_[axis] - far_origin_[axis]);
        }
        return enter <= leave;
    }

    /// Tests a shape; returns whether the search is over.
    bool test(const Primitive& primitive) {
        if constexpr (Counting) {
            counts_.objects += 1;
        }
        Ray remaining = ray_;
        const bool is_lower =
            primitive.object < best_.object ||
            (primitive.object == best_.object && primitive.number < best_.primitive);
        remaining.t_max = found() && is_lower ? std::nextafter(best_.t, kInfinity) : best_.t;
        return primitives_.closest(primitive, remaining, best_) && any_;
    }
    bool test(std::uint32_t index) { return test(primitives_.bounded()[index]); }

  private:
    const Primitives& primitives_;
    Ray ray_;
    bool any_;
    Hit best_;
    double slack_ = 0;
    V3f inverse_, near_origin_, far_origin_;
    std::array<int, 3> near_side_{};
    KindCounts counts_;
};

}  // namespace carom::render
