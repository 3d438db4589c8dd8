// Volumes between pairs of parallel planes.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

#include "lab/structures/outlines.h"
#include "render/geometry/scalar_kernels.h"

namespace carom::render {

/// A ray and slabs with one normal.
struct SlabProbe {
    float origin = 0, inverse = 0, margin = 0;

    SlabProbe() = default;
    /// `far`: ray_margin().
    SlabProbe(const Ray& ray, const V3f& normal, float far)
        : origin(normal.dot(ray.origin)),
          inverse(scalar::finite_reciprocal<scalar::One>(normal.dot(ray.direction))),
          margin(far * std::abs(inverse)) {}

    /// Restricts the interval from `enter` to `leave` to the part inside the slab.
    void cut(const Extent& slab, float& enter, float& leave) const {
        const float at_low = (slab.low - origin) * inverse;
        const float at_high = (slab.high - origin) * inverse;
        enter = std::max(enter, std::min(at_low, at_high) - margin);
        leave = std::min(leave, std::max(at_low, at_high) + margin);
    }
};

/// By how much volumes are widened for a ray, as in kernels/box_lines.h.
[[nodiscard]] inline float ray_margin(const Ray& ray) {
    const V3f& o = ray.origin;
    return 0x1p-18f * (std::abs(o.x) + std::abs(o.y) + std::abs(o.z));
}

/// For VolumeTree: the slabs of Kay and Kajiya 1986, perpendicular to the axes and the space
/// diagonals; with three slabs they are boxes along the axes.
template <std::size_t kSlabs>
struct SlabVolumes {
    static_assert(kSlabs == 3 || kSlabs == 7);
    using Volume = std::array<Extent, kSlabs>;

    [[nodiscard]] static const std::array<V3f, kSlabs>& normals();
    [[nodiscard]] static Volume around(const Outlines& outlines, std::uint32_t shape);
    [[nodiscard]] static Volume around(const Outlines& outlines,
                                       std::span<const std::uint32_t> shapes, const Volume& left,
                                       const Volume& right);

    class Probe {
      public:
        explicit Probe(const Ray& ray) : t_min_(ray.t_min) {
            for (std::size_t k = 0; k < kSlabs; ++k) {
                along_[k] = SlabProbe(ray, normals()[k], ray_margin(ray));
            }
        }
        [[nodiscard]] bool enters(const Volume& volume, float t_max, float& enter) const {
            enter = t_min_;
            float leave = t_max;
            for (std::size_t k = 0; k < kSlabs && enter <= leave; ++k) {
                along_[k].cut(volume[k], enter, leave);
            }
            return enter <= leave;
        }

      private:
        float t_min_;
        std::array<SlabProbe, kSlabs> along_;
    };
};

extern template struct SlabVolumes<3>;
extern template struct SlabVolumes<7>;

}  // namespace carom::render
