// Which pictures a film needs.
#pragma once

#include <cstdint>
#include <map>
#include <stop_token>
#include <vector>

#include "core/hash.h"
#include "pipeline/camera/frame_plan.h"
#include "pipeline/shot/shot.h"
#include "pipeline/store/frame_inputs.h"

namespace carom::pipeline {

/// A shot, its timeline and what all its frames share. Refers to both.
class FilmSource {
  public:
    /// Reads the scene's files for their hash; throws Error.
    FilmSource(const Shot& shot, const sim::Timeline& timeline);

    [[nodiscard]] const Shot& shot() const { return shot_; }
    [[nodiscard]] const sim::Timeline& timeline() const { return timeline_; }

    /// What is seen in a frame (plan_mixed_frame): two layers in a cross-fade, else one.
    [[nodiscard]] std::vector<PlannedFrame> layers(std::int64_t frame) const;

    /// What a layer's picture is rendered from, and its key.
    [[nodiscard]] FrameInputs inputs(const PlannedFrame& layer) const;
    [[nodiscard]] FrameInputs inputs(std::int64_t frame) const {  // of its first layer
        return inputs(layers(frame).front());
    }
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
        std::int64_t frame = 0;            // one whose layer number `layer` it is
        std::size_t layer = 0;             // the first layer is the one that is seen most
        std::vector<std::int64_t> frames;  // whose first layer it is, ascending
    };
    /// What is mixed into a frame in a cross-fade.
    struct Blend {
        std::size_t picture = 0;
        double weight = 0;  // (0, 1/2]
    };
    std::vector<std::int64_t> frames;     // their numbers, ascending
    std::vector<Picture> pictures;        // in order of first use
    std::vector<std::size_t> picture_of;  // for each frame of the film: its first layer
    std::map<std::size_t, Blend> blends;  // by the frame's place in the film: its second layer

    /// The second layer of the film's frame at that place, or nullptr.
    [[nodiscard]] const Blend* blend_of(std::size_t place) const {
        const auto found = blends.find(place);
        return found == blends.end() ? nullptr : &found->second;
    }
};

/// `frames` ascending. Throws Error, Stopped.
[[nodiscard]] FilmPlan plan_film(const FilmSource& source, const std::vector<std::int64_t>& frames,
                                 const std::stop_token& stop);

}  // namespace carom::pipeline
