// A shot of 32 x 18 pixels, its timeline, and a renderer that only computes a few numbers.
#pragma once

#include <cstdint>
#include <mutex>
#include <string>
#include <vector>

#include "pipeline/job/film_job.h"
#include "pipeline/job/scene_renderer.h"

namespace carom::testing {

/// Twelve frames at 24 per second: a ball rolls during the first eight and rests in the others,
/// filmed by a camera that stands still. FFV1, so that files compare fast.
[[nodiscard]] pipeline::Shot tiny_shot();

/// With one track, "cue": rolls along x from 0 s to 0.31 s, then rests.
[[nodiscard]] sim::Timeline tiny_timeline();

/// A picture that is a function of the inputs; all pictures differ.
[[nodiscard]] render::Film fake_picture(const pipeline::Shot& shot,
                                        const pipeline::FrameInputs& inputs);

/// make_film and make_frame of a bake with this timeline, with pictures by `render`.
pipeline::FilmJobResult film_by(const pipeline::RenderFunction& render, const pipeline::Shot& shot,
                                const sim::Timeline& timeline, pipeline::FilmJobOptions options,
                                const pipeline::JobObserver& observer, const std::stop_token& stop);
[[nodiscard]] render::Film frame_by(const pipeline::RenderFunction& render,
                                    const pipeline::Shot& shot, const sim::Timeline& timeline,
                                    std::int64_t frame, pipeline::FilmJobOptions options,
                                    const pipeline::JobObserver& observer,
                                    const std::stop_token& stop);

/// fake_picture, and what was asked for.
class FakeRenderer {
  public:
    explicit FakeRenderer(const pipeline::Shot& shot) : shot_(shot) {}

    [[nodiscard]] pipeline::RenderFunction function();

    /// scene_open of every picture rendered, in order.
    [[nodiscard]] std::vector<double> rendered() const;

  private:
    const pipeline::Shot& shot_;
    mutable std::mutex mutex_;
    std::vector<double> rendered_;
};

}  // namespace carom::testing
