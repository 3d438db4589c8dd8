// Small pictures of a film's frames, from the store of finished frames.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/config/shot_source.h"
#include "pipeline/job/film_plan.h"
#include "pipeline/job/frame_graphics.h"
#include "pipeline/shot/shot.h"
#include "pipeline/store/frame_store.h"
#include "pipeline/video/view_transform.h"

namespace carom::studio {

inline constexpr int kThumbnailWidth = 160;

/// Display values, row by row from the top left.
struct SmallPicture {
    std::vector<std::uint8_t> rgb;
    int width = 0;
    int height = 0;
};

/// By which a film of that width is divided.
[[nodiscard]] int thumbnail_factor(int width);

/// The bytes of a JPEG. A file in the folder, which exists, is written and removed. Throws Error.
[[nodiscard]] std::string jpeg_of(const SmallPicture& picture, const std::string& folder);

/// For one thread.
class FilmThumbnails {
  public:
    /// Of this shot; the folder of the cache is not empty. `source`: what the shot was read from,
    /// for its moments. `bake`: its motion; null: the cache has it. Throws Error.
    FilmThumbnails(pipeline::Shot shot, std::shared_ptr<const pipeline::ShotSource> source,
                   const sim::Bake* bake, const std::string& cache_folder);

    /// The frame through the film's view, with annotations, kThumbnailWidth wide or less; nothing
    /// if the cache does not have it. Throws Error.
    [[nodiscard]] std::optional<SmallPicture> small(std::int64_t frame);

    /// The same as a JPEG.
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
