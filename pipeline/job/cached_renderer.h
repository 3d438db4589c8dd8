// Renders single pictures unless the store has them.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "pipeline/job/film_plan.h"
#include "pipeline/job/scene_renderer.h"
#include "pipeline/store/frame_store.h"

namespace carom::pipeline {

enum class RenderOrigin {
    stored,             // the store already had the picture
    rendered,           // rendered now
    claimed_elsewhere,  // another process is rendering the picture: try again later
};

struct CachedRender {
    RenderOrigin origin = RenderOrigin::claimed_elsewhere;
    double seconds = 0;  // spent on rendering
    render::RenderStatistics counts{};
    std::optional<render::Film> film{};  // as it is stored, if it was rendered now
    bool twice = false;                  // somebody else had rendered it, too
    bool continued = false;              // another attempt had begun it

    [[nodiscard]] std::uint64_t rays() const {
        return counts.camera_rays + counts.scattered_rays + counts.shadow_rays;
    }
};

/// Renders a picture under a claim and stores it, unless the store already has it. A picture that
/// is denoised is stored before and after; the former is not rendered again for other settings of
/// the denoiser. For one thread
/// at a time. Refers to its arguments.
class CachedRenderer {
  public:
    /// `keeps_sums` and `threads`: those of FilmJobOptions; the threads are for denoising.
    CachedRenderer(const FilmSource& source, const FrameStore& store, RenderFunction render,
                   bool keeps_sums, int threads = 0)
        : source_(source),
          store_(store),
          render_(std::move(render)),
          keeps_sums_(keeps_sums),
          threads_(threads) {}

    /// Ensures that the store has the picture, unless another process is rendering it. When
    /// stopped, a picture that needs less than two more seconds is finished; the samples of one
    /// that needs longer are stored if they are kept, and whoever renders it next goes on with
    /// them. Throws Error, Stopped.
    CachedRender render(const FilmPlan::Picture& picture, const WorkContext& context);

    /// For people, what is waited for after `waited`, if this picture and `others` more are claimed
    /// elsewhere; `frame` is how the picture is named. Throws Error if a claim cannot be read.
    [[nodiscard]] std::string waiting_text(const FilmPlan::Picture& picture, std::int64_t frame,
                                           std::size_t others, const std::string& waited) const;

  private:
    [[nodiscard]] CachedRender render_frame(const FilmPlan::Picture& picture,
                                            const WorkContext& context);
    [[nodiscard]] CachedRender render_and_store(const FilmPlan::Picture& picture,
                                                const WorkContext& context);
    [[nodiscard]] CachedRender denoise(const FilmPlan::Picture& picture,
                                       const WorkContext& context);
    [[nodiscard]] CachedRender filter(const FilmPlan::Picture& picture, CachedRender result,
                                      const render::Film& noisy,
                                      const std::function<void()>& meanwhile,
                                      const WorkContext& context) const;
    [[nodiscard]] render::ImageMetadata metadata(const render::RenderStatistics& counts) const;
    [[nodiscard]] render::Film render_from(render::FrameSums& sums,
                                           const FilmPlan::Picture& picture,
                                           const WorkContext& context) const;
    void keep(const render::FrameSums& sums, const Hash128& key) const;

    const FilmSource& source_;
    const FrameStore& store_;
    RenderFunction render_;
    bool keeps_sums_;
    int threads_;
    double expected_seconds_ = 0;
};

}  // namespace carom::pipeline
