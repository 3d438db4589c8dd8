// Surfaces that are only partly there.
#pragma once

#include <cstdint>

#include <Imath/ImathBox.h>

#include "render/acceleration/acceleration_structure.h"

namespace carom::render {

class FrameScene;

/// What materials say about rays that pass.
class CutOuts {
  public:
    virtual ~CutOuts() = default;

    [[nodiscard]] virtual bool is_cut_out(std::uint32_t material) const = 0;
    /// The fraction of rays that meet the surface at a point of such a material, [0, 1].
    [[nodiscard]] virtual float opacity(const SurfacePoint& point) const = 0;

  protected:
    CutOuts() = default;
    CutOuts(const CutOuts&) = default;
    CutOuts& operator=(const CutOuts&) = default;
};

/// Another structure whose cut-out surfaces are hit by a fraction of rays. Whether a ray is among
/// these follows from a hash of it (as in Pharr, Jakob and Humphreys 2023, "Physically Based
/// Rendering", section 7.1.1), so that each of many similar rays decides on its own.
class CutOutStructure final : public AccelerationStructure {
  public:
    /// `scene` and `cut_outs` outlive it. `bounds`: of all surfaces that are cut out.
    CutOutStructure(const FrameScene& scene, const CutOuts& cut_outs,
                    const AccelerationStructure& whole, const Imath::Box3f& bounds)
        : scene_(scene), cut_outs_(cut_outs), whole_(whole), bounds_(bounds) {}

    [[nodiscard]] bool closest_hit(const Ray& ray, Hit& hit) const override;
    [[nodiscard]] bool any_hit(const Ray& ray) const override;
    void closest_hits(const RayBatch& rays, Hit* hits) const override;
    void test_occlusion(const RayBatch& rays, float* t_max) const override;

  private:
    [[nodiscard]] bool passes(const Ray& ray, const Hit& hit) const;
    [[nodiscard]] bool may_pass(const Ray& ray) const;
    [[nodiscard]] bool next_hit(Ray ray, Hit& hit) const;

    const FrameScene& scene_;
    const CutOuts& cut_outs_;
    const AccelerationStructure& whole_;
    Imath::Box3f bounds_;
};

}  // namespace carom::render
