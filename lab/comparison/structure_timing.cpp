#include "lab/comparison/structure_timing.h"

#include "lab/structures/make_structure.h"

namespace carom::pipeline {

render::StaticGeometry geometry_of(const LaboratoryScene& scene, render::AccelerationKind kind) {
    render::RenderSettings settings = scene.settings;
    settings.acceleration = kind;
    return {scene.scene, settings, render::make_structure};
}

RaysByKind thinned(const RaysByKind& rays, std::size_t every) {
    RaysByKind some;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        for (std::size_t k = 0; k < rays[i].size(); k += every) {
            some[i].push_back(rays[i][k]);
        }
    }
    return some;
}

}  // namespace carom::pipeline
