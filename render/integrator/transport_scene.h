// What integrators need of one frame: shapes, materials and lights, borrowed.
#pragma once

#include <cstdint>
#include <vector>

#include "render/film/film.h"
#include "render/frame_scene/frame_scene.h"
#include "render/light/light_set.h"
#include "render/material/material.h"

namespace carom::render {

class FarLight;  // render/light/far_light.h

/// Objects from `first_light_object` on are the area lights of `lights`, in their order;
/// SurfacePoint::material indexes `materials`. Everything outlives the integrator.
struct TransportScene {
    const FrameScene& frame;
    const std::vector<Material>& materials;
    const LightSet& lights;
    std::uint32_t first_light_object = 0;
    const FarLight* far = nullptr;  // of far surfaces; none: all light is computed

    [[nodiscard]] bool is_light(const Hit& hit) const { return hit.object >= first_light_object; }
    [[nodiscard]] std::size_t light_of(const Hit& hit) const {
        return hit.object - first_light_object;
    }
};

}  // namespace carom::render
