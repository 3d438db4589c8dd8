// Which pictures a film needs.
#pragma once

#include <cstdint>
#include <stop_token>
#include <vector>

#include "pipeline/shot/shot.h"
#include "pipeline/store/frame_inputs.h"
#include "sim/timeline/hash.h"

namespace carom::pipeline {

/// A shot, its timeline and what all its frames share. Refers to both.
class FilmSource {
  public:
    /// Reads the scene's files for their hash; throws Error.
    FilmSource(const Shot& shot, const sim::Timeline& timeline);

    [[nodiscard]] const Shot& shot() const { return shot_; }
    [[nodiscard]] const sim::Timeline& timeline() const { return timeline_; }

    /// What the picture of a frame is rendered from, and its key.
    [[nodiscard]] FrameInputs inputs(std::int64_t frame) const;
    [[nodiscard]] Hash128 key(const FrameInputs& inputs) const;

  private:
    const Shot& shot_;
    const sim::Timeline& timeline_;
    std::vector<CameraRig> cameras_;  // the shot's, with what has to be fitted fitted
    Hash128 scene_hash_;
};

/// A film's frames in order. Frames that show the same share one picture.
struct FilmPlan {
    struct Picture {
        Hash128 key;
        std::vector<std::int64_t> frames;  // that show it, ascending
    };
    std::vector<std::int64_t> frames;     // their numbers, ascending
    std::vector<Picture> pictures;        // in order of first use
    std::vector<std::size_t> picture_of;  // for each frame of the film
};

/// `frames` ascending. Throws Error, Stopped.
[[nodiscard]] FilmPlan plan_film(const FilmSource& source, const std::vector<std::int64_t>& frames,
                                 const std::stop_token& stop);

}  // namespace carom::pipeline
