// Samples of lights by their kernels, empty where no light arrives.
#pragma once

#include <optional>
#include <type_traits>

#include "render/light/area_light.h"
#include "render/light/delta_light.h"
#include "render/light/emissive_shape.h"
#include "render/light/emissive_surface.h"
#include "render/light/environment.h"
#include "render/light/light_set.h"
#include "render/light/scalar_kernels.h"

namespace carom::render {

[[nodiscard]] inline AreaLightConstants constants_of(const auto& light) {
    return area_light_of({"light", light})->constants;
}

using LightSample = scalar::LightSampleOf<scalar::One>;

[[nodiscard]] inline std::optional<LightSample> if_valid(const LightSample& sample) {
    return sample.valid ? std::optional(sample) : std::nullopt;
}
template <class Emitter>
[[nodiscard]] std::optional<LightSample> light_sample(const Emitter& light, const V3f& point,
                                                      const V2f& u) {
    using scalar::One;
    if constexpr (std::is_same_v<Emitter, EmissiveSurface>) {
        const EmissiveSurfaceConstants surface = light.constants();
        const auto seen = scalar::see_tree<One>(surface.tree, point, V3f(0, 0, 1));
        return if_valid(scalar::sample_surface<One>(surface, seen, point, u));
    } else {
        return if_valid(scalar::sample_shape<One>(light.constants(), point, u));
    }
}
[[nodiscard]] inline std::optional<LightSample> light_sample(const AreaLightConstants& light,
                                                             const V3f& point, const V2f& u) {
    return if_valid(scalar::sample_area_light<scalar::One>(light, point, u));
}
[[nodiscard]] inline std::optional<LightSample> light_sample(const DeltaLight& light,
                                                             const V3f& point) {
    return if_valid(scalar::sample_delta_light<scalar::One>(light.constants(), point));
}
[[nodiscard]] inline std::optional<LightSample> light_sample(const Environment& light,
                                                             const V2f& u) {
    using scalar::One;
    const EnvironmentPicture picture = light.picture();
    const auto found = scalar::sample_environment_map<One>(picture, u);
    return if_valid({found.direction, kInfinity, found.pdf,
                     scalar::environment_radiance<One>(picture, found.uv), found.valid});
}
[[nodiscard]] inline float pdf(const Environment& light, const V3f& direction) {
    using scalar::One;
    const EnvironmentPicture picture = light.picture();
    return scalar::environment_pdf<One>(picture, direction,
                                        scalar::environment_uv<One>(picture, direction));
}

}  // namespace carom::render
