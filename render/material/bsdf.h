// The BSDF at one point for one direction of view: evaluation, sampling, density.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

#include "render/geometry/ray.h"
#include "render/geometry/validity.h"
#include "render/material/lobe_weights.h"
#include "render/material/material.h"
#include "render/material/phong_lobes.h"
#include "render/sampling/warp.h"

namespace carom::render {

/// The part of a surface that scatters. A path may follow the coat and the layers below it
/// separately: the values of the two parts add up to the whole.
enum class Layers : std::uint8_t { all, coat, base };

struct BsdfValue {
    V3f value{0, 0, 0};  // BSDF times cosine of the incoming direction, 1/sr
    float pdf = 0;  // density with which `sample` makes that direction, 1/sr; without delta lobes
};

struct BsdfSample {
    V3f direction;          // unit, world, away from the surface
    V3f weight;             // value / pdf; of a delta lobe its reflectance over its probability
    float pdf = 0;          // 1/sr; meaningless for a delta lobe
    bool is_delta = false;  // a specular direction, which only this lobe samples
};

/// All directions are unit vectors in world axes that point away from the surface. Light comes only
/// from the viewer's side, except through glass. `wo` is the direction to the path's previous
/// vertex.
class Bsdf {
  public:
    Bsdf(const Surface& surface, const V3f& wo);

    /// Whether the surface has a coat that can be followed separately.
    [[nodiscard]] bool has_coat() const { return lobes_.coat() > 0; }

    /// A diffuse lobe, albedo / pi.
    struct Diffuse {
        V3f albedo;
        float probability;  // with which `sample` chooses it
    };
    /// The diffuse lobe if there is no other non-specular lobe; otherwise empty.
    [[nodiscard]] std::optional<Diffuse> only_diffuse(Layers layers) const {
        return is_lambert(layers)
                   ? std::optional(Diffuse{lobes_.diffuse(), 1.0f - coat_probability(layers)})
                   : std::nullopt;
    }

    /// Whether a non-specular lobe exists, so that `evaluate` is not 0 everywhere.
    [[nodiscard]] bool can_evaluate(Layers layers) const;

    /// Whether all non-specular lobes are wide.
    [[nodiscard]] bool is_broad() const;

    /// Whether the surface transmits light from behind it.
    [[nodiscard]] bool transmits() const {
        return lobes_.glass() > 0 || (phong_ && phong_->transmits());
    }

    /// Value and density for light from `wi`; both 0 below the surface unless it transmits.
    [[nodiscard]] BsdfValue evaluate(Layers layers, const V3f& wi) const {
        BsdfValue result = evaluate_any(layers, wi);
        CAROM_VALIDATE(is_light(result.value) && result.pdf >= 0 && !std::isnan(result.pdf));
        return result;
    }

    /// Samples a direction for `u` in [0, 1)^2. Empty: the light is absorbed and contributes 0. The
    /// weight is below 1 / (probability of the chosen part) for every channel.
    [[nodiscard]] std::optional<BsdfSample> sample(Layers layers, const V2f& u) const {
        std::optional<BsdfSample> result = sample_any(layers, u);
        CAROM_VALIDATE(!result || (is_unit(result->direction) && is_light(result->weight)));
        return result;
    }

    [[nodiscard]] float pdf(Layers layers, const V3f& wi) const { return evaluate(layers, wi).pdf; }

  private:
    [[nodiscard]] BsdfValue evaluate_any(Layers layers, const V3f& wi) const {
        if (phong_) {
            return layers == Layers::coat ? BsdfValue{} : evaluate_phong(wi);
        }
        if (surface_->geometric_normal.dot(wi) <= 0) {
            return lobes_.glass() > 0 ? evaluate_through(layers, surface_->frame.from_world(wi))
                                      : BsdfValue{};
        }
        return is_lambert(layers) ? lambert(layers, surface_->frame.z.dot(wi))
                                  : evaluate_local(layers, surface_->frame.from_world(wi));
    }
    [[nodiscard]] std::optional<BsdfSample> sample_any(Layers layers, const V2f& u) const;
    [[nodiscard]] float coat_probability(Layers layers) const {
        return layers == Layers::coat ? 1.0f
                                      : (layers == Layers::base ? 0.0f : lobes_.coat_choice());
    }
    /// Whether a diffuse base is the only non-specular lobe: the most frequent and cheapest case.
    [[nodiscard]] bool is_lambert(Layers layers) const {
        return lobes_.is_diffuse() &&
               (layers == Layers::base || (layers == Layers::all && !lobes_.has_rough_coat()));
    }
    [[nodiscard]] BsdfValue lambert(Layers layers, float cosine) const {
        const float density = std::max(cosine, 0.0f) * kInversePi;
        return {lobes_.diffuse() * density, (1.0f - coat_probability(layers)) * density};
    }
    [[nodiscard]] BsdfValue evaluate_phong(const V3f& wi) const;
    [[nodiscard]] std::optional<BsdfSample> sample_phong(const V2f& u) const;
    [[nodiscard]] BsdfValue evaluate_coat(const V3f& wi) const;
    [[nodiscard]] BsdfValue evaluate_base(const V3f& wi) const;
    [[nodiscard]] BsdfValue evaluate_through(Layers layers, const V3f& wi) const;
    // The following functions take directions in the surface's own axes; `probability`: of the
    // decisions before the call.
    [[nodiscard]] BsdfValue evaluate_local(Layers layers, const V3f& wi) const;
    [[nodiscard]] std::optional<BsdfSample> sample_coat(Layers layers, const V2f& u,
                                                        float probability) const;
    [[nodiscard]] std::optional<BsdfSample> sample_base(Layers layers, const V2f& u,
                                                        float probability) const;
    [[nodiscard]] std::optional<BsdfSample> sample_glass(Layers layers, const V2f& u,
                                                         float probability) const;
    [[nodiscard]] std::optional<BsdfSample> mirror(const V3f& weight) const;
    [[nodiscard]] std::optional<BsdfSample> pass(const V3f& wi, const V3f& weight) const;
    [[nodiscard]] std::optional<BsdfSample> finish(Layers layers, const V3f& wi,
                                                   bool passes = false) const;

    const Surface* surface_;
    V3f wo_;  // in the surface's axes, z > 0
    LobeWeights lobes_;
    std::optional<PhongLobes> phong_;  // replaces the layers
};

}  // namespace carom::render
