// Bounding spheres.
#pragma once

#include <cstdint>
#include <span>

#include "lab/structures/outlines.h"

namespace carom::render {

/// For VolumeTree. The sphere of a node is the smaller one of two: the least sphere around those of
/// both halves, and the one about the middle of the box around the shapes that reaches the farthest
/// of them.
struct SphereVolumes {
    struct Volume {
        V3f centre;
        float radius = 0;
    };

    [[nodiscard]] static Volume around(const Outlines& outlines, std::uint32_t shape);
    [[nodiscard]] static Volume around(const Outlines& outlines,
                                       std::span<const std::uint32_t> shapes, const Volume& left,
                                       const Volume& right);

    class Probe {
      public:
        explicit Probe(const Ray& ray);
        [[nodiscard]] bool enters(const Volume& volume, float t_max, float& enter) const;

      private:
        V3f origin_, direction_;
        float t_min_, margin_;
    };
};

}  // namespace carom::render
