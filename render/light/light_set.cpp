#include "render/light/light_set.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "render/light/area_light.h"
#include "render/light/scalar_kernels.h"
#include "render/scene/scene_problems.h"

namespace carom::render {

using scalar::One;

LightSet::LightSet(const std::vector<LightDescription>& lights,
                   std::shared_ptr<const Environment> directions) {
    if (const std::vector<Diagnostic> problems = find_problems(lights); !problems.empty()) {
        throw Error(problems.front().sentence);
    }
    std::vector<DeltaLight> delta_lights;
    for (const LightDescription& description : lights) {
        if (const auto* environment = std::get_if<EnvironmentLight>(&description.light)) {
            environment_ = std::make_shared<const Environment>(*environment);
        } else if (const std::optional<AreaLight> area_light = area_light_of(description)) {
            lights_.emplace_back(area_light->constants);
        } else if (const std::optional<DeltaLight> delta_light = delta_light_of(description)) {
            delta_lights.push_back(*delta_light);
        }
    }
    area_light_count_ = lights_.size();
    directions_ = directions ? std::move(directions) : environment_;
    if (directions_->is_sampled()) {
        lights_.emplace_back(SampledEnvironment());
    }
    lights_.insert(lights_.end(), delta_lights.begin(), delta_lights.end());
    first_emissive_ = lights_.size();
}

void LightSet::add(std::uint32_t object, EmissiveObject emissive) {
    if (emissive.is_black()) {
        return;
    }
    if (object >= light_of_object_.size()) {
        light_of_object_.resize(object + 1);
    }
    light_of_object_[object] = lights_.size();
    lights_.emplace_back(std::move(emissive));
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

std::optional<LightBounds> bounds_of(const Light& light) {
    if (const auto* area = std::get_if<AreaLightConstants>(&light)) {
        return area->has_falloff ? std::optional(bounds_of(*area)) : std::nullopt;
    }
    if (const auto* delta = std::get_if<DeltaLight>(&light)) {
        return delta->constants().has_falloff ? std::optional(delta->bounds()) : std::nullopt;
    }
    const auto* object = std::get_if<EmissiveObject>(&light);
    return object != nullptr ? std::optional(object->bounds()) : std::nullopt;
}

V3f LightSet::emitted(std::size_t light, const V3f& position, const V3f& direction) const {
    return scalar::emitted_by_area_light<One>(area_light(light), position, direction);
}

}  // namespace carom::render
