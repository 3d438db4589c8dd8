// One picture: from the store, or rendered under a claim and stored.
#pragma once

#include <cstdint>
#include <optional>

#include "pipeline/job/film_plan.h"
#include "pipeline/job/scene_renderer.h"
#include "pipeline/store/frame_store.h"

namespace carom::pipeline {

enum class RenderOrigin {
    stored,    // was there
    rendered,  // now
    held,      // another process is at it: come back later
};

struct CachedRender {
    RenderOrigin origin = RenderOrigin::held;
    double seconds = 0;  // spent rendering
    render::RenderStatistics counts{};
    std::optional<render::Film> film{};  // as the store holds it, if it was rendered now

    [[nodiscard]] std::uint64_t rays() const {
        return counts.camera_rays + counts.scattered_rays + counts.shadow_rays;
    }
};

/// For one thread at a time. Refers to its arguments.
class CachedRenderer {
  public:
    CachedRenderer(const FilmSource& source, const FrameStore& store, RenderFunction render)
        : source_(source), store_(store), render_(std::move(render)) {}

    /// Sees to it that the store has the picture, unless another process is about to. When stopped,
    /// a picture that needs less than two seconds more is finished. Throws Error, Stopped.
    CachedRender make(const FilmPlan::Picture& picture, const WorkContext& context);

  private:
    const FilmSource& source_;
    const FrameStore& store_;
    RenderFunction render_;
    double expected_seconds_ = 0;
};

}  // namespace carom::pipeline
