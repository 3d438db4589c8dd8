// The plan of a film: the pictures that its frames need.
#pragma once

#include <cstdint>
#include <map>
#include <stop_token>
#include <string>
#include <vector>

#include "core/hash.h"
#include "pipeline/camera/frame_plan.h"
#include "pipeline/shot/shot.h"
#include "pipeline/store/frame_inputs.h"

namespace carom::pipeline {

/// A shot, its timeline and the data that all its frames share. Refers to both.
class FilmSource {
  public:
    /// Reads the scene's files to hash them. Throws Error.
    FilmSource(const Shot& shot, const sim::Timeline& timeline);

    [[nodiscard]] const Shot& shot() const { return shot_; }
    [[nodiscard]] const sim::Timeline& timeline() const { return timeline_; }

    /// The layers of a frame (plan_mixed_frame): two in a cross-fade, otherwise one.
    [[nodiscard]] std::vector<PlannedFrame> layers(std::int64_t frame) const;

    /// The inputs from which a layer's picture is rendered, and its key.
    [[nodiscard]] FrameInputs inputs(const PlannedFrame& layer) const;
    [[nodiscard]] FrameInputs inputs(std::int64_t frame) const {  // of its first layer
        return inputs(layers(frame).front());
    }
    [[nodiscard]] Hash128 key(const FrameInputs& inputs) const;
    /// The key of the picture before it is denoised; the same if it is not.
    [[nodiscard]] Hash128 noisy_key(const FrameInputs& inputs) const;
    /// noisy_key() with other settings than the shot's.
    [[nodiscard]] Hash128 key(const FrameInputs& inputs,
                              const render::RenderSettings& settings) const;
    /// hash_scene() of the shot.
    [[nodiscard]] const Hash128& scene_hash() const { return scene_hash_; }

  private:
    const Shot& shot_;
    const sim::Timeline& timeline_;
    std::vector<CameraRig> cameras_;  // of the shot, with paths that are fitted to the timeline
    Hash128 scene_hash_;
};

/// The frames of a film in order. Frames that show the same share one picture.
struct FilmPlan {
    struct Picture {
        Hash128 key;
        std::int64_t frame = 0;            // a frame that has this picture as its layer `layer`
        std::size_t layer = 0;             // the first layer is the one with the largest weight
        std::vector<std::int64_t> frames;  // that have it as their first layer, ascending
        Hash128 noisy_key{};               // of the picture before it is denoised, else the same
    };
    /// The picture that is mixed into a frame in a cross-fade.
    struct Blend {
        std::size_t picture = 0;
        double weight = 0;  // (0, 1/2]
    };
    std::vector<std::int64_t> frames;     // their numbers, ascending
    std::vector<Picture> pictures;        // in order of first use
    std::vector<std::size_t> picture_of;  // for each frame of the film: its first layer
    std::map<std::size_t, Blend> blends;  // by the frame's index in the film: its second layer

    /// The second layer of the film's frame with that index, or nullptr.
    [[nodiscard]] const Blend* blend_of(std::size_t index) const {
        const auto found = blends.find(index);
        return found == blends.end() ? nullptr : &found->second;
    }
};

/// `frames` must be ascending. Throws Error, Stopped.
[[nodiscard]] FilmPlan plan_film(const FilmSource& source, const std::vector<std::int64_t>& frames,
                                 const std::stop_token& stop);

}  // namespace carom::pipeline
