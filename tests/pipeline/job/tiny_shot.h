// A shot of 32 x 18 pixels, its timeline, and a fake renderer that only computes a few numbers.
#pragma once

#include <cstdint>
#include <mutex>
#include <string>
#include <vector>

#include "pipeline/job/film_job.h"
#include "pipeline/job/scene_renderer.h"

namespace carom::testing {

/// A shot of twelve frames at 24 per second: a ball rolls during the first eight and rests in the
/// others, filmed by a fixed camera. The codec is FFV1, so that files can be
/// compared quickly.
[[nodiscard]] pipeline::Shot tiny_shot();

/// Its timeline. The only track, "cue", rolls along x from 0 s to 0.31 s, then rests.
[[nodiscard]] sim::Timeline tiny_timeline();

/// A picture that is a function of the inputs. Different inputs give different pictures.
[[nodiscard]] render::Film fake_picture(const pipeline::Shot& shot,
                                        const pipeline::FrameInputs& inputs);

/// Calls make_film or make_frame for a bake with this timeline, with pictures that `render` makes.
pipeline::FilmJobResult make_film_with(const pipeline::RenderFunction& render,
                                       const pipeline::Shot& shot, const sim::Timeline& timeline,
                                       pipeline::FilmJobOptions options,
                                       const pipeline::JobObserver& observer,
                                       const std::stop_token& stop);
[[nodiscard]] render::Film make_frame_with(const pipeline::RenderFunction& render,
                                           const pipeline::Shot& shot,
                                           const sim::Timeline& timeline, std::int64_t frame,
                                           pipeline::FilmJobOptions options,
                                           const pipeline::JobObserver& observer,
                                           const std::stop_token& stop);

/// A renderer that returns fake_picture and records the calls.
class FakeRenderer {
  public:
    explicit FakeRenderer(const pipeline::Shot& shot) : shot_(shot) {}

    [[nodiscard]] pipeline::RenderFunction function();

    /// scene_open of every rendered picture, in order.
    [[nodiscard]] std::vector<double> rendered() const;

  private:
    const pipeline::Shot& shot_;
    mutable std::mutex mutex_;
    std::vector<double> rendered_;
};

}  // namespace carom::testing
