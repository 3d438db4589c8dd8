// The shapes of one frame, set up for its shutter interval: what integrators trace against.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <Imath/ImathBox.h>

#include "render/acceleration/measured_structure.h"
#include "render/acceleration/structure_cost.h"
#include "render/scene/render_settings.h"
#include "sim/timeline/track.h"

namespace carom::render {

struct SceneObject;    // render/frame_scene/scene_object.h
class StaticGeometry;  // render/frame_scene/static_geometry.h: what all frames share

/// Moving spheres keep their exact paths (Hermite stretches with the instants of impacts between
/// them); still shapes come from `StaticGeometry`.
class FrameScene {
  public:
    /// `scene_open` <= `scene_close`, seconds of scene time. `geometry` outlives this. Throws Error
    /// if an object names a track that is not among `tracks`. `options` are for the structures that
    /// the literature compares; `hybrid` and `embree` neither count nor look beyond the first hit.
    FrameScene(const StaticGeometry& geometry, std::span<const sim::Track> tracks,
               double scene_open, double scene_close, const StructureOptions& options = {});
    ~FrameScene();
    FrameScene(const FrameScene&) = delete;
    FrameScene& operator=(const FrameScene&) = delete;

    [[nodiscard]] const AccelerationStructure& structure() const { return *structure_; }
    /// So far.
    [[nodiscard]] StructureCost cost() const;

    /// The point that `hit` names, at the ray's own time.
    [[nodiscard]] SurfacePoint surface_at(const Ray& ray, const Hit& hit) const;

    /// Where the point of the object's surface that is at `position` at one time of the shutter is
    /// at another; both in [0, 1].
    [[nodiscard]] V3f moved(std::uint32_t object, const V3f& position, float from_time,
                            float to_time) const;

    /// A sphere, still or moving.
    struct Ball {
        std::uint32_t object = 0;
        std::uint32_t material = 0;
        float radius = 0;
        Imath::Box3f centres;  // every place that its centre takes
    };
    /// All of them that have a material, in order of object.
    [[nodiscard]] std::vector<Ball> balls() const;
    [[nodiscard]] V3f centre(std::uint32_t object, float time) const;

    /// As its description says.
    [[nodiscard]] const SceneObject& object(std::uint32_t object) const;
    /// Whether it follows a track.
    [[nodiscard]] bool moves(std::uint32_t object) const;
    [[nodiscard]] std::size_t object_count() const;
    [[nodiscard]] std::uint32_t material(std::uint32_t object) const;

  private:
    struct Data;
    std::unique_ptr<Data> data_;
    std::unique_ptr<MeasuredStructure> structure_;
    double build_seconds_ = 0;
};

}  // namespace carom::render
