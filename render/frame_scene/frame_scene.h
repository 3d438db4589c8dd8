// The shapes of one frame during its shutter interval, for integrators.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <Imath/ImathBox.h>
#include <Imath/ImathQuat.h>

#include "render/acceleration/acceleration_structure.h"
#include "render/scene/render_settings.h"
#include "sim/timeline/track.h"

namespace carom::render {

struct SceneObject;    // render/frame_scene/scene_object.h
class RigidMotion;     // render/geometry/rigid_motion.h
class StaticGeometry;  // render/frame_scene/static_geometry.h: shared by all frames
class CutOuts;         // render/frame_scene/cut_outs.h

/// Moving spheres keep their exact paths (Hermite segments between impacts); static shapes come
/// from `StaticGeometry`.
class FrameScene {
  public:
    /// `scene_open` <= `scene_close`, s of scene time. `geometry`, `cut_outs` (null: nothing is cut
    /// out) and `near` (null: the same; else a part of `geometry`) outlive this object. Throws
    /// Error if an object names a track that is not among `tracks`.
    FrameScene(const StaticGeometry& geometry, std::span<const sim::Track> tracks,
               double scene_open, double scene_close, const CutOuts* cut_outs = nullptr,
               const StaticGeometry* near = nullptr);
    ~FrameScene();
    FrameScene(const FrameScene&) = delete;
    FrameScene& operator=(const FrameScene&) = delete;

    [[nodiscard]] const AccelerationStructure& structure() const { return *structure_; }
    /// Of what is near, if a part of the geometry is.
    [[nodiscard]] const AccelerationStructure& near() const { return near_ ? *near_ : *structure_; }
    /// Of whole surfaces, whatever is cut out of them.
    [[nodiscard]] const AccelerationStructure& uncut() const {
        return whole_ ? *whole_ : *structure_;
    }

    /// The surface point of `hit` at the ray's time.
    [[nodiscard]] SurfacePoint surface_at(const Ray& ray, const Hit& hit) const;

    /// Where a point of the object's surface, given by its `position` at one time of the shutter,
    /// is at another; both times in [0, 1].
    [[nodiscard]] V3f moved(std::uint32_t object, const V3f& position, float from_time,
                            float to_time) const;

    /// A sphere, static or moving.
    struct Sphere {
        std::uint32_t object = 0;
        std::uint32_t material = 0;
        float radius = 0;
        Imath::Box3f centres;  // box around all positions of its centre
    };
    /// All spheres with a material, in the order of their objects.
    [[nodiscard]] std::vector<Sphere> spheres() const;
    /// The position of the object's body, or of its unit shape's centre if it follows no track.
    [[nodiscard]] V3f centre(std::uint32_t object, float time) const;
    /// The rotation of an object that follows a track.
    [[nodiscard]] Imath::Quatf world_from_body(std::uint32_t object, float time) const;

    /// The object as described in the scene.
    [[nodiscard]] const SceneObject& object(std::uint32_t object) const;
    /// By object: its motion during the shutter; null if it follows no track.
    [[nodiscard]] std::span<const std::shared_ptr<const RigidMotion>> motions() const;
    /// Around all places of the object; infinite for planes.
    [[nodiscard]] Imath::Box3f bounds(std::uint32_t object) const;
    /// Whether it follows a track.
    [[nodiscard]] bool moves(std::uint32_t object) const;
    [[nodiscard]] std::size_t object_count() const;
    [[nodiscard]] std::uint32_t material(std::uint32_t object) const;

  private:
    struct Data;
    std::unique_ptr<Data> data_;
    std::unique_ptr<AccelerationStructure> whole_;  // if some surfaces are cut out
    std::unique_ptr<AccelerationStructure> structure_;
    std::unique_ptr<AccelerationStructure> near_whole_, near_;  // likewise, of what is near
};

}  // namespace carom::render
