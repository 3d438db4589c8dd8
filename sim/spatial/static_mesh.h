// Static triangle surfaces and the impacts and contacts of balls with them.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "sim/motion/contact.h"
#include "sim/motion/motion_segment.h"
#include "sim/spatial/aabb_tree.h"
#include "sim/spatial/mesh_features.h"

namespace carom::sim {

/// A contact with a surface; the normal points towards the body that touches it.
struct SurfaceContact : Contact {
    std::uint32_t surface = 0;
};

/// A set of surfaces. Each one is decomposed into features when a body first comes near it: a table
/// has tens of thousands of triangles, of which a shot uses few.
/// Copies share what was decomposed. Const methods may be called by several threads.
class StaticMesh {
  public:
    /// `surface`: the caller's number of the surface, which contacts return.
    void add(std::vector<Vec3> vertices, std::vector<MeshTriangle> triangles,
             std::uint32_t surface);

    struct FeatureImpact {
        double time = 0;
        std::uint32_t feature = 0;
    };

    /// The first impact in [now, until] of a ball on that segment, by the rules of
    /// time_of_impact.h.
    [[nodiscard]] std::optional<FeatureImpact> first_impact(const MotionSegment& ball,
                                                            double radius, double now,
                                                            double until) const;

    [[nodiscard]] SurfaceContact contact(std::uint32_t feature, const Vec3& centre,
                                         double radius) const;

    struct Part;  // of the mesh: one surface
    /// The features near a ball, which are found anew only where it has moved farther than `slack`
    /// from `centre`. For one mesh and one ball.
    struct NearFeatures {
        struct Item {
            const Part* part;
            std::uint32_t index;
            Aabb box;
        };
        Vec3 centre{0, 0, 0};
        double slack = -1;  // m; negative: nothing has been found yet
        std::vector<Item> items;
    };
    /// The contacts of a ball at rest with gaps up to `margin`, the deepest first. Of contacts with
    /// nearly the same normal only one is kept.
    [[nodiscard]] std::vector<SurfaceContact> contacts(const Vec3& centre, double radius,
                                                       double margin, NearFeatures& near) const;
    [[nodiscard]] std::vector<SurfaceContact> contacts(const Vec3& centre, double radius,
                                                       double margin) const {
        NearFeatures near;
        return contacts(centre, radius, margin, near);
    }

    /// A triangle; its corners are counter-clockwise seen against `normal`.
    struct Triangle {
        std::array<Vec3, 3> corners;
        Vec3 normal{0, 0, 1};
        std::uint32_t surface = 0;
    };
    /// All triangles whose bounds overlap `bounds`, in a fixed order.
    [[nodiscard]] std::vector<Triangle> triangles_near(const Aabb& bounds) const;

    [[nodiscard]] bool empty() const { return parts_.empty(); }

    struct Part {
        std::vector<Vec3> vertices;
        std::vector<MeshTriangle> triangles;
        std::uint32_t surface = 0;
        std::uint32_t first_feature = 0;  // features are counted through all parts
        Aabb bounds;
        mutable std::once_flag is_prepared;
        mutable std::vector<MeshFeature> features;
        mutable AabbTree tree;
    };

  private:
    void find_near(const Vec3& centre, double distance, NearFeatures& near) const;
    static void prepare(const Part& part);
    [[nodiscard]] const Part& part_of(std::uint32_t feature) const;

    std::vector<std::shared_ptr<const Part>> parts_;
    std::uint32_t next_feature_ = 0;
};

/// The bounding box of a ball's centre during [from, to].
[[nodiscard]] Aabb swept_bounds(const MotionSegment& ball, double from, double to);

}  // namespace carom::sim
