// The fields of the render settings, in the order in which they are hashed (core/fields.h).
#pragma once

#include "core/fields.h"
#include "render/scene/render_settings.h"

namespace carom::render {

constexpr auto fields_of(Describes<DistributedSettings>) {
    using T = DistributedSettings;
    return fields<T>(
        field("pixel_samples", &T::pixel_samples), field("blur_samples", &T::blur_samples),
        field("lens_samples", &T::lens_samples), field("shadow_samples", &T::shadow_samples),
        field("reflection_samples", &T::reflection_samples),
        field("refraction_samples", &T::refraction_samples),
        field("recursion_limit", &T::recursion_limit), field("falloff", &T::falloff),
        field("ambient_coefficient", &T::ambient_coefficient));
}

constexpr auto fields_of(Describes<RenderSettings>) {
    using T = RenderSettings;
    return fields<T>(field("width", &T::width), field("height", &T::height),
                     field("integrator", &T::integrator), field("samples", &T::samples),
                     field("noise", &T::noise), field("max_samples", &T::max_samples),
                     field("max_bounces", &T::max_bounces), field("distributed", &T::distributed),
                     field("clamp", &T::clamp), field("filter", &T::filter),
                     field("filter_width", &T::filter_width),
                     field("acceleration", &T::acceleration), field("seed", &T::seed),
                     field("aovs", &T::aovs), field("for_denoiser", &T::for_denoiser));
}

}  // namespace carom::render
