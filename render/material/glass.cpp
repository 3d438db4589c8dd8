#include "render/material/glass.h"

#include <algorithm>

#include "core/elementary_float.h"
#include "render/material/lobe_constants.h"

namespace carom::render {
namespace {

// Below this index no refraction or reflection is visible.
constexpr float kLeastBendingIndex = 1.001f;
constexpr float kLeastColour = 1e-4f;

float clamped(double value, double least, double most) {
    return static_cast<float>(std::clamp(value, least, most));
}

V3f absorption_of(const StandardMaterial& m) {
    const auto rate = [&](double colour) {
        return -logarithm(clamped(colour, kLeastColour, 1)) /
               static_cast<float>(m.transmission_depth);
    };
    const Vec3& colour = m.transmission_colour;
    return {rate(colour.x), rate(colour.y), rate(colour.z)};
}

}  // namespace

V3f GlassConstants::transmittance(float distance) const {
    return {exponential(-absorption.x * distance), exponential(-absorption.y * distance),
            exponential(-absorption.z * distance)};
}

std::shared_ptr<const GlassConstants> glass_constants(const StandardMaterial& m,
                                                      AlbedoTables& tables) {
    if (m.transmission <= 0) {
        return nullptr;
    }
    auto glass = std::make_shared<GlassConstants>();
    glass->ior = clamped(m.ior, 1.0, 3.0);
    const double roughness = m.roughness.constant_or(0.5);
    const float alpha = clamped(roughness * roughness, 0, 1);
    glass->alpha = alpha < kSmoothAlpha || glass->ior < kLeastBendingIndex ? 0.0f : alpha;
    if (m.transmission_depth > 0) {
        glass->absorption = absorption_of(m);
    } else {
        glass->tint = V3f(m.transmission_colour);
    }
    if (glass->alpha > 0) {
        glass->reflected[0] = tables.of_dielectric(glass->alpha, glass->ior);
        glass->reflected[1] = tables.of_dielectric(glass->alpha, 1.0f / glass->ior);
        glass->kept[0] = tables.of_glass(glass->alpha, glass->ior);
        glass->kept[1] = tables.of_glass(glass->alpha, 1.0f / glass->ior);
    }
    return glass;
}

}  // namespace carom::render
