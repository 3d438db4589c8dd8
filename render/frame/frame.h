// One frame: from a prepared scene, a timeline and the camera's values to pixels.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "core/progress.h"
#include "render/acceleration/structure_factory.h"
#include "render/camera/camera_state.h"
#include "render/film/film.h"
#include "render/scene/render_settings.h"
#include "render/scene/scene_description.h"
#include "sim/timeline/timeline.h"

namespace carom::render {

struct StructureProbe;  // render/acceleration/structure_cost.h

/// Bumped whenever the renderer's pixels change for the same inputs.
inline constexpr int kRendererRevision = 11;

/// A frame's own inputs besides scene and tracks. Canonical: scene_open <= scene_close.
struct FrameInput {
    CameraState camera_open;   // at scene_open; equal to camera_close: the camera stands still
    CameraState camera_close;  // at scene_close
    double scene_open = 0;     // the shutter's interval in scene time, s
    double scene_close = 0;
    /// Share of the exposure spent opening and closing (together), [0, 1]: 0 is a box, 1 a
    /// triangle.
    double switch_ratio = 0;
    std::uint64_t seed = 0;  // of all random numbers: what chooses the noise
};

/// What all frames of a shot share: meshes, textures, the structure over still shapes. Immutable;
/// any number of threads may render from it. Construction reads files and throws Error naming the
/// file. `factory` makes the structures that the library does not make itself; without it those are
/// an Error (find_problem()).
class PreparedScene {
  public:
    PreparedScene(const SceneDescription& scene, const RenderSettings& settings,
                  StructureFactory factory = nullptr);
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
/// linear light. The pixels depend on the arguments alone, not on threads; any number of threads
/// may call at the same time. `tracks` need only hold the tracks that the scene names; a name
/// without a track is an Error, and so are settings with problems. Throws Stopped. `probe`: what
/// finding hits cost is measured; the pixels stay the same.
[[nodiscard]] Film render_frame(const PreparedScene& scene, std::span<const sim::Track> tracks,
                                const FrameInput& frame, const RenderSettings& settings,
                                const WorkContext& context = {}, StructureProbe* probe = nullptr);

}  // namespace carom::render
