// The GGX distribution of microfacet normals with Smith's masking, in the surface's own axes (z is
// the normal). Walter et al. 2007, "Microfacet models for refraction through rough surfaces"; Heitz
// 2014, "Understanding the masking-shadowing function in microfacet-based BRDFs".
#pragma once

#include "render/geometry/ray.h"
#include "render/material/scalar_kernels.h"
#include "render/sampling/warp.h"

namespace carom::render {

// The formulas and their sources are in kernels/microfacet.h.
class Ggx {
  public:
    /// `alpha` in [kSmoothAlpha, 1].
    explicit Ggx(float alpha) : ggx_(alpha) {}

    /// Density of normals, 1/sr. `m`: unit, m.z > 0.
    [[nodiscard]] float density(const V3f& m) const { return ggx_.density(scalar::three(m)); }

    /// Masked over visible microfacet area. Requires `w.z` > 0.
    [[nodiscard]] float lambda(const V3f& w) const { return ggx_.lambda(scalar::three(w)); }

    /// A visible normal for `wo`, with density G1(wo) max(0, wo.m) D(m) / wo.z.
    [[nodiscard]] V3f sample_visible(const V3f& wo, const V2f& u) const {
        return scalar::vector_of(ggx_.sample_visible(scalar::three(wo), scalar::two(u)));
    }

    /// Density (1/sr of the reflected direction) of reflection at a normal from `sample_visible`.
    [[nodiscard]] float reflection_pdf(const V3f& wo, const V3f& m) const {
        return ggx_.reflection_pdf(scalar::three(wo), scalar::three(m));
    }

    /// BRDF times cosine of `wi`, for facets that reflect everything.
    [[nodiscard]] float reflection(const V3f& wo, const V3f& wi, const V3f& m) const {
        return ggx_.reflection(scalar::three(wo), scalar::three(wi), scalar::three(m));
    }

    /// reflection / reflection_pdf: weight of a direction reflected at a normal from
    /// sample_visible.
    [[nodiscard]] float sample_weight(const V3f& wo, const V3f& wi) const {
        const float masked = 1.0f + lambda(wo);
        return masked / (masked + lambda(wi));
    }

  private:
    scalar::GgxOf<scalar::One> ggx_;
};

/// `w` reflected at the facet with unit normal `m`.
[[nodiscard]] inline V3f reflect(const V3f& w, const V3f& m) {
    return scalar::vector_of(scalar::reflect<scalar::One>(scalar::three(w), scalar::three(m)));
}

/// The refracted direction on the far side of a facet `m`, with w.m > 0 and `index` of the far side
/// over that of `w`; (0, 0, 0) at total reflection (Walter 2007, eq. 40).
[[nodiscard]] inline V3f refracted_at(const V3f& w, const V3f& m, float index) {
    return scalar::vector_of(
        scalar::refracted_at<scalar::One>(scalar::three(w), scalar::three(m), index));
}

}  // namespace carom::render
