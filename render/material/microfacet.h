// The GGX distribution of microfacet normals with Smith's masking, in the surface's own axes (z is
// the normal). Walter et al. 2007, "Microfacet models for refraction through rough surfaces"; Heitz
// 2014, "Understanding the masking-shadowing function in microfacet-based BRDFs".
#pragma once

#include <algorithm>
#include <cmath>

#include "render/geometry/ray.h"
#include "render/sampling/warp.h"

namespace carom::render {

/// A lobe narrower than this is treated as specular.
inline constexpr float kSmoothAlpha = 1e-3f;

class Ggx {
  public:
    /// `alpha` in [kSmoothAlpha, 1].
    explicit Ggx(float alpha) : alpha_(alpha), alpha2_(alpha * alpha) {}

    /// Density of normals, 1/sr (Walter 2007, eq. 33, with tan = sin / cos, which is accurate near
    /// the normal). `m`: unit, m.z > 0.
    [[nodiscard]] float density(const V3f& m) const {
        const float slope2 = (m.x * m.x + m.y * m.y) / alpha2_;
        const float k = slope2 + m.z * m.z;
        return kInversePi / (alpha2_ * k * k);
    }

    /// Heitz 2014, eq. 72: masked over visible microfacet area. Requires `w.z` > 0.
    [[nodiscard]] float lambda(const V3f& w) const {
        const float tan2 = (w.x * w.x + w.y * w.y) / (w.z * w.z);
        return 0.5f * (std::sqrt(1.0f + alpha2_ * tan2) - 1.0f);
    }

    /// A visible normal for `wo`, with density G1(wo) max(0, wo.m) D(m) / wo.z (Heitz 2018,
    /// "Sampling the GGX distribution of visible normals"; by spherical caps: Dupuy and Benyoub
    /// 2023, "Sampling visible GGX normals with spherical caps", listing 3).
    [[nodiscard]] V3f sample_visible(const V3f& wo, const V2f& u) const {
        const V3f stretched = V3f(alpha_ * wo.x, alpha_ * wo.y, wo.z).normalized();
        const SinCos angle = sin_cos_turn(u.x);
        const float z = (1.0f - u.y) * (1.0f + stretched.z) - stretched.z;
        const float sine = std::sqrt(std::clamp(1.0f - z * z, 0.0f, 1.0f));
        const V3f h = V3f(sine * angle.cosine, sine * angle.sine, z) + stretched;
        return V3f(alpha_ * h.x, alpha_ * h.y, std::max(h.z, 1e-7f)).normalized();
    }

    /// Density (1/sr of the reflected direction) of reflection at a normal from `sample_visible`.
    [[nodiscard]] float reflection_pdf(const V3f& wo, const V3f& m) const {
        return density(m) / (4.0f * wo.z * (1.0f + lambda(wo)));
    }

    /// BRDF times cosine of `wi`, for facets that reflect everything (Heitz 2014, eq. 99 with the
    /// height-correlated masking of its G2).
    [[nodiscard]] float reflection(const V3f& wo, const V3f& wi, const V3f& m) const {
        return density(m) / (4.0f * wo.z * (1.0f + lambda(wo) + lambda(wi)));
    }

    /// reflection / reflection_pdf: weight of a direction reflected at a normal from
    /// sample_visible.
    [[nodiscard]] float sample_weight(const V3f& wo, const V3f& wi) const {
        const float masked = 1.0f + lambda(wo);
        return masked / (masked + lambda(wi));
    }

  private:
    float alpha_;
    float alpha2_;
};

/// `w` reflected at the facet with unit normal `m`.
[[nodiscard]] inline V3f reflect(const V3f& w, const V3f& m) {
    return m * (2.0f * w.dot(m)) - w;
}

/// The refracted direction on the far side of a facet `m`, with w.m > 0 and `index` of the far side
/// over that of `w`; (0, 0, 0) at total reflection (Walter 2007, eq. 40).
[[nodiscard]] inline V3f refracted_at(const V3f& w, const V3f& m, float index) {
    const float cosine = w.dot(m);
    const float inverse = 1.0f / index;
    const float through2 = 1.0f - inverse * inverse * (1.0f - cosine * cosine);
    if (through2 <= 0) {
        return V3f(0, 0, 0);
    }
    return m * (inverse * cosine - std::sqrt(through2)) - w * inverse;
}

}  // namespace carom::render
