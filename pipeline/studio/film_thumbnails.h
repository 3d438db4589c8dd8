// Small pictures of a film's frames, from the store of finished frames.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "pipeline/job/film_plan.h"
#include "pipeline/job/frame_graphics.h"
#include "pipeline/shot/shot.h"
#include "pipeline/store/frame_store.h"
#include "pipeline/video/view_transform.h"

namespace carom::studio {

inline constexpr int kThumbnailWidth = 160;

/// For one thread.
class FilmThumbnails {
  public:
    /// Of this shot, of which the cache has the bake; its folder is not empty. Throws Error.
    FilmThumbnails(pipeline::Shot shot, const std::string& cache_folder);

    /// The frame through the film's view, with annotations, as a JPEG, kThumbnailWidth wide or
    /// less; nothing if the cache does not have it. Throws Error.
    [[nodiscard]] std::optional<std::string> jpeg(std::int64_t frame);

  private:
    std::string folder_;
    pipeline::Shot shot_;
    sim::Timeline timeline_;
    pipeline::FilmSource source_;
    pipeline::FrameStore store_;
    pipeline::DisplayView view_;
    pipeline::FrameGraphics graphics_;
};

/// The film smaller by a whole factor, so that it is at most that wide: means of its pixels.
/// Without other channels than colours.
[[nodiscard]] render::Film reduced(const render::Film& film, int width);

}  // namespace carom::studio
