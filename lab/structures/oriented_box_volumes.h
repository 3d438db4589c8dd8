// Boxes in any direction.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "lab/structures/slab_volumes.h"

namespace carom::render {

/// For VolumeTree. Of four directions the box with the smallest surface is taken: along the axes of
/// the world, along the principal axes of the shapes (Gottschalk, Lin and Manocha 1996, "OBBTree: a
/// hierarchical structure for rapid interference detection", section 4), and as the boxes of both
/// halves.
struct OrientedBoxVolumes {
    struct Volume {
        std::array<V3f, 3> axes;
        std::array<Extent, 3> extents;
    };

    [[nodiscard]] static Volume around(const Outlines& outlines, std::uint32_t shape);
    [[nodiscard]] static Volume around(const Outlines& outlines,
                                       std::span<const std::uint32_t> shapes, const Volume& left,
                                       const Volume& right);

    class Probe {
      public:
        explicit Probe(const Ray& ray) : ray_(ray), margin_(ray_margin(ray)) {}

        [[nodiscard]] bool enters(const Volume& volume, float t_max, float& enter) const {
            enter = ray_.t_min;
            float leave = t_max;
            for (std::size_t k = 0; k < 3 && enter <= leave; ++k) {
                SlabProbe(ray_, volume.axes[k], margin_).cut(volume.extents[k], enter, leave);
            }
            return enter <= leave;
        }

      private:
        const Ray& ray_;
        float margin_;
    };
};

}  // namespace carom::render
