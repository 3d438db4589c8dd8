// Rendering of one frame from a prepared scene, tracks and the camera's parameters.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "core/progress.h"
#include "render/acceleration/structure_maker.h"
#include "render/camera/camera_state.h"
#include "render/film/film.h"
#include "render/scene/render_settings.h"
#include "render/scene/scene_description.h"
#include "sim/timeline/timeline.h"

namespace carom::render {

class FarLight;   // render/light/far_light.h
class FrameSums;  // render/frame/frame_sums.h

/// Incremented whenever the renderer's pixels change for the same inputs.
inline constexpr int kRendererRevision = 21;

/// The inputs of a frame besides scene and tracks. Canonical: scene_open <= scene_close.
struct FrameInput {
    CameraState camera_open;   // at scene_open; equal to camera_close if the camera is at rest
    CameraState camera_close;  // at scene_close
    double scene_open = 0;     // the shutter's interval in scene time, s
    double scene_close = 0;
    /// Fraction of the exposure in which the shutter opens and closes, [0, 1]: 0 is a box, 1 a
    /// triangle.
    double switch_ratio = 0;
    std::uint64_t seed = 0;  // of all random numbers
};

/// What all frames of a shot share: meshes, textures, the structure over static shapes. Immutable;
/// any number of threads may render from it. Construction reads files and throws Error with the
/// file's name. `maker`: if given, it makes the acceleration structures; without it, a name in
/// RenderSettings::acceleration that is not kOwnStructure is an Error. `far`: the light of far
/// surfaces if the scene has a far region and it is known; else it is computed, which takes long.
class PreparedScene {
  public:
    PreparedScene(const SceneDescription& scene, const RenderSettings& settings,
                  StructureMaker maker = {}, std::shared_ptr<const FarLight> far = nullptr);
    ~PreparedScene();
    PreparedScene(PreparedScene&&) noexcept;
    PreparedScene& operator=(PreparedScene&&) noexcept;
    PreparedScene(const PreparedScene&) = delete;
    PreparedScene& operator=(const PreparedScene&) = delete;

    struct Data;
    [[nodiscard]] const Data& data() const { return *data_; }

  private:
    std::unique_ptr<const Data> data_;
};

/// Renders one frame, tiles in parallel on oneTBB: settings.width x settings.height pixels of
/// linear light. The pixels depend only on the arguments, not on threads; any number of threads
/// may call at the same time. `tracks` must contain the tracks that the scene names; a missing
/// track is an Error, and so are settings with problems. Throws Stopped. `sums`: if given, sampling
/// resumes from them and saves its state there even when it is stopped; once it is finished they
/// are empty. The pixels are the same.
[[nodiscard]] Film render_frame(const PreparedScene& scene, std::span<const sim::Track> tracks,
                                const FrameInput& frame, const RenderSettings& settings,
                                const WorkContext& context = {}, FrameSums* sums = nullptr);

}  // namespace carom::render
