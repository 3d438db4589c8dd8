// The BSDF's kernels for one direction of view, one number at a time.
#pragma once

#include <memory>
#include <optional>

#include "render/geometry/validity.h"
#include "render/material/material.h"
#include "render/material/scalar_kernels.h"

namespace carom::render::test_materials {

/// The part of a surface that scatters. A path may follow the coat and the layers below it
/// separately.
enum class Layers { all, coat, base };

struct BsdfValue {
    V3f value{0, 0, 0};
    float pdf = 0;
};

struct BsdfSample {
    V3f direction;
    V3f weight;
    float pdf = 0;
    bool is_delta = false;
};

/// Of a material without a texture, on a surface with this normal. Directions are in world axes.
class Bsdf {
    using One = scalar::One;

  public:
    Bsdf(const Material& material, const V3f& normal, const V3f& wo)
        : material_(std::make_shared<const Material>(material)) {
        const bool from_behind = normal.dot(wo) < 0;
        const auto front = from_behind ? -normal : normal;
        bsdf_.layers = material_->numbers();
        scalar::complete<One>(bsdf_, *material_->constant_base(), front, front, wo, from_behind);
    }

    [[nodiscard]] bool can_evaluate(Layers layers) const {
        const auto kinds = scalar::kinds_of_lobes<One>(bsdf_);
        return (layers != Layers::base && kinds.coat_scatters) ||
               (layers != Layers::coat && kinds.base_scatters);
    }
    [[nodiscard]] bool transmits() const { return bsdf_.transmits; }

    [[nodiscard]] BsdfValue evaluate(Layers layers, const V3f& wi) const {
        const auto local = bsdf_.frame.from_world(wi);
        const auto side = scalar::side_of<One>(bsdf_, wi, local.z);
        BsdfValue result;
        if (!side.is_above && !side.passes) {
            return result;
        }
        const auto coat = scalar::coat_towards<One>(bsdf_, local, side.passes);
        const auto base = scalar::base_towards<One>(bsdf_, local, side.passes);
        const auto found = layers == Layers::all    ? scalar::of_all_lobes<One>(bsdf_, base, coat)
                           : layers == Layers::coat ? coat
                                                    : base;
        return {found.value, found.pdf};
    }
    [[nodiscard]] float pdf(Layers layers, const V3f& wi) const { return evaluate(layers, wi).pdf; }

    /// Empty: the light is absorbed.
    [[nodiscard]] std::optional<BsdfSample> sample(Layers layers, const V2f& u) const {
        const bool splits = layers != Layers::all;
        const bool takes_coat =
            splits ? layers == Layers::coat : u.x < bsdf_.lobes.coat_probability;
        const scalar::Vec2<float> rest{scalar::after_choice<One>(bsdf_, splits, u.x), u.y};
        const auto to = takes_coat ? scalar::sample_coat<One>(bsdf_, splits, !splits, rest)
                                   : scalar::sample_base<One>(bsdf_, splits, rest);
        const auto side = scalar::side_of<One>(bsdf_, to.world, to.wi.z);
        const bool agrees = to.passes ? side.passes : side.is_above;
        if (!to.valid || !agrees) {
            return std::nullopt;
        }
        BsdfSample sample{to.world, to.weight, to.pdf, to.is_delta};
        CAROM_VALIDATE(is_unit(sample.direction) && is_light(sample.weight));
        return sample;
    }

  private:
    std::shared_ptr<const Material> material_;  // has the tables
    scalar::BsdfOf<One> bsdf_{};
};

}  // namespace carom::render::test_materials
