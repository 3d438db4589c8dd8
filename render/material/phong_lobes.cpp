#include "render/material/phong_lobes.h"

#include <algorithm>
#include <cmath>

#include "core/colour.h"
#include "core/elementary_float.h"
#include "render/geometry/orthonormal_basis.h"
#include "render/geometry/trigonometry.h"
#include "render/sampling/remap_sample.h"
#include "render/sampling/warp.h"

namespace carom::render {
namespace {

constexpr float kBroadest = 32.0f;  // exponent up to which a lobe is wide

/// Rotates `w` by half a turn about the unit `axis`.
V3f turned(const V3f& w, const V3f& axis) {
    return axis * (2 * axis.dot(w)) - w;
}

/// The direction on the other side from which light is refracted towards the unit `wo` (Snell);
/// empty at total reflection. `index`: of that side over this one.
std::optional<V3f> refracted(const V3f& wo, float index) {
    const float sine2 = (1 - wo.z * wo.z) / (index * index);
    if (sine2 >= 1) {
        return std::nullopt;
    }
    return V3f(-wo.x / index, -wo.y / index, -std::sqrt(1 - sine2));
}

}  // namespace

PhongLobes::Lobe::Lobe(const V3f& the_albedo, const V3f& the_axis, const CosineLobe& shape)
    : albedo(the_albedo),
      axis(the_axis),
      exponent(shape.exponent),
      kept(shape.exponent < 0 ? 1.0f : shape.kept.at(std::abs(the_axis.z))) {}

float PhongLobes::Lobe::density(const V3f& wi) const {
    const float cosine = axis.dot(wi);
    return cosine > 0 ? (exponent + 1) * (0.5f * kInversePi) * power(cosine, exponent) : 0.0f;
}

float PhongLobes::Lobe::pdf(const V3f& wi) const {
    return density(wi) * (has_on_its_side(turned(wi, axis)) ? 1.0f : 2.0f);
}

V3f PhongLobes::Lobe::sampled(const V2f& u) const {
    const float cosine = power(1 - u.x, 1 / (exponent + 1));
    const float sine = std::sqrt(std::max(0.0f, 1 - cosine * cosine));
    const SinCos azimuth = sin_cos_turn(u.y);
    const V3f wi = OrthonormalBasis::around(axis)
                       .to_world(V3f(sine * azimuth.cosine, sine * azimuth.sine, cosine))
                       .normalized();
    return has_on_its_side(wi) ? wi : turned(wi, axis).normalized();
}

PhongLobes::PhongLobes(const PhongModel& model, const V3f& base, bool from_behind, const V3f& wo)
    : diffuse_(model.diffuse_colour(base)) {
    const V3f mirror(-wo.x, -wo.y, wo.z);
    highlight_ = Lobe(model.specular, mirror, model.highlight_lobe);
    mirrored_ = Lobe(model.reflectance_colour(base), mirror, model.mirrored_lobe);
    if (largest(model.transmittance) > 0) {
        const auto beyond = refracted(wo, from_behind ? 1 / model.index : model.index);
        through_ = Lobe(model.transmittance, beyond.value_or(mirror), model.through_lobe);
    }
    const float total = largest(diffuse_ + highlight_.albedo + mirrored_.albedo + through_.albedo);
    if (total > 1) {
        diffuse_ /= total;
        for (Lobe* lobe : {&highlight_, &mirrored_, &through_}) {
            lobe->albedo /= total;
        }
    }
    const float sum = largest(diffuse_) + largest(highlight_.albedo) + largest(mirrored_.albedo) +
                      largest(through_.albedo);
    if (sum > 0) {
        diffuse_probability_ = largest(diffuse_) / sum;
        for (Lobe* lobe : {&highlight_, &mirrored_, &through_}) {
            lobe->probability = largest(lobe->albedo) / sum;
        }
    }
}

PhongLobes::Value PhongLobes::evaluate(const V3f& wi) const {
    Value result;
    const auto add = [&](const Lobe& lobe) {
        if (lobe.probability > 0 && !lobe.is_delta() && lobe.has_on_its_side(wi)) {
            result.value += lobe.albedo * (lobe.density(wi) / lobe.kept);
            result.pdf += lobe.probability * lobe.pdf(wi);
        }
    };
    if (wi.z > 0) {
        const float cosine = wi.z * kInversePi;
        result.value = diffuse_ * cosine;
        result.pdf = diffuse_probability_ * cosine;
    }
    add(highlight_);
    add(mirrored_);
    add(through_);
    return result;
}

std::optional<PhongLobes::Sample> PhongLobes::sample(const V2f& u) const {
    V2f square = u;
    float left = 1;  // probability of the remaining lobes
    for (const Lobe* lobe : {&through_, &mirrored_, &highlight_}) {
        if (lobe->probability <= 0) {
            continue;
        }
        const float probability = std::min(1.0f, lobe->probability / left);
        const bool is_taken = square.x < probability || probability == 1;
        if (probability < 1) {
            square.x = remap_sample(square.x, probability);
        }
        left -= lobe->probability;
        if (!is_taken) {
            continue;
        }
        if (lobe->is_delta()) {
            return Sample{lobe->axis, lobe->albedo / lobe->probability, true};
        }
        const V3f direction = lobe->sampled(square);
        if (!lobe->has_on_its_side(direction)) {
            return std::nullopt;  // by rounding, parallel to the surface
        }
        return Sample{direction, V3f(0, 0, 0), false};
    }
    if (diffuse_probability_ <= 0) {
        return std::nullopt;
    }
    const V3f direction = sample_cosine_hemisphere(square);
    if (direction.z <= 0) {
        return std::nullopt;  // parallel to the surface: zero density
    }
    return Sample{direction, V3f(0, 0, 0), false};
}

bool PhongLobes::can_evaluate() const {
    const auto spreads = [](const Lobe& lobe) { return lobe.probability > 0 && !lobe.is_delta(); };
    return diffuse_probability_ > 0 || spreads(highlight_) || spreads(mirrored_) ||
           spreads(through_);
}

bool PhongLobes::is_broad() const {
    const auto is_wide = [](const Lobe& lobe) {
        return lobe.probability <= 0 || lobe.is_delta() || lobe.exponent <= kBroadest;
    };
    return can_evaluate() && is_wide(highlight_) && is_wide(mirrored_) && is_wide(through_);
}

}  // namespace carom::render
