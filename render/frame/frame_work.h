// What rendering one frame needs, in whatever order its samples are taken. Internal to this folder.
#pragma once

#include <span>

#include "core/progress.h"
#include "render/frame/aov_planes.h"
#include "render/frame/frame.h"
#include "render/frame/tile_renderer.h"
#include "render/frame_scene/frame_scene.h"
#include "render/integrator/transport_scene.h"

namespace carom::render {

/// `scene` must outlive it. Throws as render_frame does.
class FrameWork {
  public:
    FrameWork(const PreparedScene& scene, std::span<const sim::Track> tracks,
              const FrameInput& frame, const RenderSettings& settings,
              const StructureOptions& options = {});

    [[nodiscard]] const RenderSettings& settings() const { return settings_; }
    [[nodiscard]] const FrameScene& scene() const { return frame_scene_; }
    [[nodiscard]] const TileRenderer& tiles() const { return tiles_; }

    /// Number of pixels.
    [[nodiscard]] std::size_t pixel_count() const {
        return static_cast<std::size_t>(settings_.width) *
               static_cast<std::size_t>(settings_.height);
    }
    /// A black film of the frame's size.
    [[nodiscard]] Film empty_film() const;
    /// The planes of the channels with these names.
    [[nodiscard]] AovPlanes make_aovs(const std::vector<std::string>& names) const;

    /// The planes for the denoiser; empty unless the settings ask for them.
    [[nodiscard]] DenoiserPlanes make_denoiser_planes() const;

    /// Adds the images of lights in balls, with as many samples as the pixels of `film` have on
    /// average, and counts their rays in `film`; their halves to `planes` unless these are empty.
    /// Throws Stopped.
    void add_reflections(Film& film, DenoiserPlanes& planes, const WorkContext& context) const;

  private:
    void add_reflections(Film& film, double samples, int half, RenderStatistics& statistics,
                         const WorkContext& context) const;

    const PreparedScene& prepared_;
    RenderSettings settings_;
    FrameInput frame_;
    FrameScene frame_scene_;
    LightSet lights_;
    TransportScene transport_;
    TileRenderer tiles_;
};

}  // namespace carom::render
