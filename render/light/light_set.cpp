#include "render/light/light_set.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "render/light/area_light.h"
#include "render/light/scalar_kernels.h"
#include "render/scene/scene_problems.h"

namespace carom::render {

using scalar::One;

LightSet::LightSet(const std::vector<LightDescription>& lights) {
    if (const std::vector<Diagnostic> problems = find_problems(lights); !problems.empty()) {
        throw Error(problems.front().sentence);
    }
    for (const LightDescription& description : lights) {
        if (const auto* environment = std::get_if<EnvironmentLight>(&description.light)) {
            environment_ = std::make_shared<const Environment>(*environment);
        } else if (const std::optional<AreaLight> area_light = area_light_of(description)) {
            area_lights_.push_back(area_light->constants);
        } else if (const std::optional<DeltaLight> delta_light = delta_light_of(description)) {
            delta_lights_.push_back(*delta_light);
        }
    }
}

void LightSet::add(std::uint32_t object, EmissiveObject emissive) {
    if (emissive.is_black()) {
        return;
    }
    if (object >= light_of_object_.size()) {
        light_of_object_.resize(object + 1);
    }
    light_of_object_[object] = sampled_count();
    emissive_.push_back(std::move(emissive));
}

void LightSet::add_tracked(std::uint32_t object, EmissiveObject emissive) {
    tracked_.push_back({object, std::move(emissive)});
}

LightSet LightSet::in_frame(std::span<const std::shared_ptr<const RigidMotion>> motions) const {
    LightSet result = *this;
    for (const Tracked& tracked : tracked_) {
        result.add(tracked.object, tracked.emissive.moving(motions[tracked.object]));
    }
    return result;
}

bool LightSet::is_round(std::size_t light) const {
    if (light >= first_emissive()) {
        return emissive_[light - first_emissive()].is_round();
    }
    return light < area_lights_.size() && area_lights_[light].is_round;
}

V3f LightSet::emitted(std::size_t light, const V3f& direction) const {
    return scalar::emitted_by_area_light<One>(area_lights_[light], direction);
}

}  // namespace carom::render
