// All lights of a scene, and the sampling of one of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "render/geometry/ray.h"
#include "render/light/delta_light.h"
#include "render/light/emissive_object.h"
#include "render/light/environment.h"
#include "render/scene/scene_description.h"

namespace carom::render {

/// Lights that can be sampled are numbered from 0: area lights in the order of the description,
/// then the environment if it is sampled, then delta lights, then emissive objects, first those
/// that follow no track. Immutable after construction; shared by all threads. Copies share pictures
/// and meshes. `time`: in [0, 1] of the shutter; it matters for moving objects only.
class LightSet {
  public:
    LightSet() = default;

    /// Throws Error with the first problem of the lights (scene_problems.h), or with the name of a
    /// picture that cannot be read.
    explicit LightSet(const std::vector<LightDescription>& lights);

    /// Adds an object with an emissive material to the sampled lights, unless it is dark. Must be
    /// called before the set is shared.
    void add(std::uint32_t object, EmissiveObject emissive);
    /// Adds an object that follows a track, likewise; only `in_frame` makes it a sampled light.
    void add_tracked(std::uint32_t object, EmissiveObject emissive);

    /// The lights of one frame. `motions`: by object, the motion of those that follow a track.
    [[nodiscard]] LightSet in_frame(
        std::span<const std::shared_ptr<const RigidMotion>> motions) const;

    /// The number of the light that the object is; none if the object is not sampled.
    [[nodiscard]] std::optional<std::size_t> emissive_light(std::uint32_t object) const {
        return object < light_of_object_.size() ? light_of_object_[object] : std::nullopt;
    }

    [[nodiscard]] std::size_t area_light_count() const { return area_lights_.size(); }
    [[nodiscard]] std::size_t sampled_count() const { return first_emissive() + emissive_.size(); }
    /// Lights from this number on are objects.
    [[nodiscard]] std::size_t first_emissive() const {
        return first_delta() + delta_lights_.size();
    }
    [[nodiscard]] bool is_environment(std::size_t light) const {
        return light == area_lights_.size() && environment_->is_sampled();
    }
    /// Whether the light is a delta light: one direction leads to it from any point.
    [[nodiscard]] bool is_delta(std::size_t light) const {
        return light >= first_delta() && light < first_emissive();
    }

    /// Whether it is sampled over the cone that a sphere subtends.
    [[nodiscard]] bool is_round(std::size_t light) const;

    /// Radiance of an area light towards the unit `direction`, away from the light, as cameras and
    /// specular reflections see it.
    [[nodiscard]] V3f emitted(std::size_t light, const V3f& direction) const;
    [[nodiscard]] const AreaLightConstants& area_light(std::size_t light) const {
        return area_lights_[light];
    }
    [[nodiscard]] const DeltaLight& delta_light(std::size_t light) const {
        return delta_lights_[light - first_delta()];
    }
    [[nodiscard]] const Environment& environment() const { return *environment_; }
    [[nodiscard]] const EmissiveObject& emissive_object(std::size_t light) const {
        return emissive_[light - first_emissive()];
    }

  private:
    [[nodiscard]] std::size_t first_delta() const {
        return area_lights_.size() + (environment_->is_sampled() ? 1 : 0);
    }

    std::vector<AreaLightConstants> area_lights_;
    std::shared_ptr<const Environment> environment_ = std::make_shared<const Environment>();
    std::vector<DeltaLight> delta_lights_;
    std::vector<EmissiveObject> emissive_;
    std::vector<std::optional<std::size_t>> light_of_object_;
    struct Tracked {
        std::uint32_t object = 0;
        EmissiveObject emissive;
    };
    std::vector<Tracked> tracked_;
};

}  // namespace carom::render
