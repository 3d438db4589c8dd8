// A scene of the laboratory that is quick to compare.
#pragma once

#include <string>

#include "lab/comparison/comparison.h"

namespace carom::pipeline {

inline LaboratoryScene small_scene(const std::string& name, int width = 16, int height = 16) {
    LaboratoryScene scene = make_laboratory_scene(name);
    scene.settings.width = width;
    scene.settings.height = height;
    scene.settings.distributed.pixel_samples = 1;
    return scene;
}

inline ComparisonOptions options_of(const std::string& structures,
                                    std::vector<ShadowRays> shadow_rays = {ShadowRays::any}) {
    ComparisonOptions options;
    options.structures = structures_from_text(structures);
    options.shadow_rays = std::move(shadow_rays);
    options.enough_seconds = 0;
    return options;
}

inline Comparison compared(const LaboratoryScene& scene, const ComparisonOptions& options) {
    return compare_structures(scene, options, [](std::string_view, double) {}, {});
}

}  // namespace carom::pipeline
