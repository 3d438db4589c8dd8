// Triangle surfaces that do not move, and a ball's way to them.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sim/motion/stretch.h"
#include "sim/spatial/aabb_tree.h"
#include "sim/spatial/mesh_features.h"

namespace carom::sim {

/// Where a ball touches a surface, or nearly does.
struct SurfaceContact {
    Vec3 point{0, 0, 0};
    Vec3 normal{0, 0, 1};  // unit, towards the ball's centre
    double depth = 0;      // how far the ball reaches behind it, m; negative: a gap
    std::uint32_t surface = 0;
};

class StaticMesh {
  public:
    StaticMesh() = default;
    explicit StaticMesh(const MeshFeatures& features);

    struct Touch {
        double time = 0;
        std::uint32_t feature = 0;
    };

    /// The first touch in [now, until] of a ball on that stretch, by the rules of
    /// time_of_impact.h.
    [[nodiscard]] std::optional<Touch> first_touch(const Stretch& ball, double radius, double now,
                                                   double until) const;

    [[nodiscard]] SurfaceContact contact(std::uint32_t feature, const Vec3& centre,
                                         double radius) const;

    /// All contacts of a ball at rest there with gaps up to `margin`, the deepest first; those
    /// with nearly the same normal are one.
    [[nodiscard]] std::vector<SurfaceContact> contacts(const Vec3& centre, double radius,
                                                       double margin) const;

    [[nodiscard]] bool empty() const { return features_.empty(); }
    /// False if nothing of the mesh can be within `box`.
    [[nodiscard]] bool may_reach(const Aabb& box) const;

  private:
    std::vector<MeshFeature> features_;
    AabbTree tree_;
};

/// The box that a ball's centre stays in during [from, to].
[[nodiscard]] Aabb swept_bounds(const Stretch& ball, double from, double to);

}  // namespace carom::sim
