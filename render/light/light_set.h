// All lights of a scene, and the sampling of one of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "render/geometry/ray.h"
#include "render/light/delta_light.h"
#include "render/light/emissive_object.h"
#include "render/light/environment.h"
#include "render/light/light_tree.h"
#include "render/scene/scene_description.h"

namespace carom::render {

/// The set's environment, if it is sampled.
struct SampledEnvironment {};

using Light = std::variant<AreaLightConstants, SampledEnvironment, DeltaLight, EmissiveObject>;

/// What a tree needs to know of it; empty for a light whose strength does not depend on the
/// distance.
[[nodiscard]] std::optional<LightBounds> bounds_of(const Light& light);

/// Lights that can be sampled are numbered from 0: area lights in the order of the description,
/// then the environment if it is sampled, then delta lights, then emissive objects, first those
/// that follow no track. Immutable after construction; shared by all threads. Copies share pictures
/// and meshes. `time`: in [0, 1] of the shutter; it matters for moving objects only.
class LightSet {
  public:
    LightSet() = default;

    /// Throws Error with the first problem of the lights (scene_problems.h), or with the name of a
    /// picture that cannot be read.
    /// `directions`: if given, paths look for the environment, and for far surfaces, in its
    /// directions.
    explicit LightSet(const std::vector<LightDescription>& lights,
                      std::shared_ptr<const Environment> directions = nullptr);

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

    /// That can be sampled, by their numbers.
    [[nodiscard]] const std::vector<Light>& lights() const { return lights_; }
    [[nodiscard]] std::size_t area_light_count() const { return area_light_count_; }
    /// Lights from this number on are objects.
    [[nodiscard]] std::size_t first_emissive() const { return first_emissive_; }
    /// Whether the light is a delta light: one direction leads to it from any point.
    [[nodiscard]] bool is_delta(std::size_t light) const {
        return std::holds_alternative<DeltaLight>(lights_[light]);
    }
    [[nodiscard]] const AreaLightConstants& area_light(std::size_t light) const {
        return std::get<AreaLightConstants>(lights_[light]);
    }
    [[nodiscard]] const DeltaLight& delta_light(std::size_t light) const {
        return std::get<DeltaLight>(lights_[light]);
    }
    [[nodiscard]] const Environment& environment() const { return *environment_; }
    /// By whose brightness directions are sampled; mostly that of the environment itself.
    [[nodiscard]] const Environment& directions() const { return *directions_; }

    /// Radiance of an area light from its point `position` towards the unit `direction`, away from
    /// the light, as cameras and specular reflections see it.
    [[nodiscard]] V3f emitted(std::size_t light, const V3f& position, const V3f& direction) const;

  private:
    std::vector<Light> lights_;
    std::size_t area_light_count_ = 0, first_emissive_ = 0;
    std::shared_ptr<const Environment> environment_ = std::make_shared<const Environment>();
    std::shared_ptr<const Environment> directions_ = environment_;
    std::vector<std::optional<std::size_t>> light_of_object_;
    struct Tracked {
        std::uint32_t object = 0;
        EmissiveObject emissive;
    };
    std::vector<Tracked> tracked_;
};

}  // namespace carom::render
