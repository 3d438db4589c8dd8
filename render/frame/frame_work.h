// What rendering one frame needs, in whatever order its samples are taken. Internal to this folder.
#pragma once

#include <span>

#include "core/progress.h"
#include "render/frame/aov_planes.h"
#include "render/frame/frame.h"
#include "render/frame/sample_plan.h"
#include "render/frame/splat_moments.h"
#include "render/frame/tile_renderer.h"
#include "render/frame_scene/frame_scene.h"
#include "render/integrator/transport_scene.h"

namespace carom::render {

/// `scene` must outlive it. Throws as render_frame does.
class FrameWork {
  public:
    FrameWork(const PreparedScene& scene, std::span<const sim::Track> tracks,
              const FrameInput& frame, const RenderSettings& settings);

    [[nodiscard]] const RenderSettings& settings() const { return settings_; }
    [[nodiscard]] const FrameScene& scene() const { return frame_scene_; }
    [[nodiscard]] const TileRenderer& tiles() const { return tiles_; }

    /// Number of pixels.
    [[nodiscard]] std::size_t pixel_count() const {
        return static_cast<std::size_t>(settings_.width) *
               static_cast<std::size_t>(settings_.height);
    }
    /// Where a pixel is in values that are stored row by row.
    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(settings_.width) +
               static_cast<std::size_t>(x);
    }
    /// A black film of the frame's size.
    [[nodiscard]] Film empty_film() const;
    /// The planes of the channels with these names.
    [[nodiscard]] AovPlanes make_aovs(const std::vector<std::string>& names) const;

    /// The planes for the denoiser; empty unless the settings ask for them.
    [[nodiscard]] DenoiserPlanes make_denoiser_planes() const;

    /// Adds the images of lights in balls, with as many samples as the pixels of `film` have on
    /// average, and counts their rays in `film`; their halves to `planes` and their variance to
    /// `aovs`. Throws Stopped.
    void add_reflections(Film& film, DenoiserPlanes& planes, AovPlanes& aovs,
                         const WorkContext& context) const;

    /// Adds the variance of these images to `aovs` alone, for pictures with so many `samples` per
    /// pixel. Throws Stopped.
    void add_reflections(AovPlanes& aovs, double samples, const WorkContext& context) const;

    /// What the camera rays of all pixels saw, of which `sums` are known; empty unless it is for
    /// the denoiser. Throws Stopped.
    [[nodiscard]] std::vector<TracedFeatures> trace_features(std::vector<PixelSums>& sums,
                                                             const WorkContext& context) const;

    /// The next round of adaptive sampling (sample_plan.h) for a frame that has all samples of
    /// `plan`. `features`: of all pixels. The images of lights in balls are traced for it; these
    /// rays are not counted. Throws Stopped.
    [[nodiscard]] SampleRound next_round(std::vector<PixelSums>& sums,
                                         const std::vector<TracedFeatures>& features,
                                         const std::vector<int>& plan,
                                         const WorkContext& context) const;

  private:
    /// A half of the samples, of which there are `samples` per pixel.
    struct Half {
        double samples = 0;
        int index = 0;
        float weight = 1;  // in the picture
    };
    using Images = std::vector<std::vector<Splat>>;
    [[nodiscard]] MeasuredError measured_error(std::vector<PixelSums>& sums,
                                               const std::vector<TracedFeatures>& features,
                                               const WorkContext& context) const;
    /// The images of lights in balls of each half: one picture with all samples, or two if the
    /// samples are taken in halves. Their variance is added to `moments` unless it is empty.
    [[nodiscard]] std::vector<Film> reflections(double samples, RenderStatistics& statistics,
                                                SplatMoments& moments,
                                                const WorkContext& context) const;
    [[nodiscard]] Images trace_reflections(const Half& half, RenderStatistics& statistics,
                                           const WorkContext& context) const;
    /// One half with all samples, or two if the samples are taken in halves.
    [[nodiscard]] std::vector<Half> halves(double samples) const;
    [[nodiscard]] SplatMoments measured(double samples, const WorkContext& context) const;

    const PreparedScene& prepared_;
    RenderSettings settings_;
    FrameInput frame_;
    FrameScene frame_scene_;
    LightSet lights_;
    TransportScene transport_;
    TileRenderer tiles_;
};

}  // namespace carom::render
