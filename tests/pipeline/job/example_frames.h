// Small frames of the example films, for tests of what their pixels depend on.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "pipeline/job/film_plan.h"
#include "pipeline/shot/shot.h"
#include "render/film/film.h"
#include "sim/timeline/timeline.h"

namespace carom::testing {

/// Paths of all shots in examples/ and its folders, sorted.
[[nodiscard]] std::vector<std::string> example_files();

/// An example, simulated and ready to be rendered at a small size.
class ExampleFilm {
  public:
    /// `path`: of the shot; `bakes`: a folder where examples of the same physics share a bake.
    /// Throws Error.
    ExampleFilm(const std::string& path, const std::string& bakes);

    /// May be changed between frames, but neither the world nor the cameras.
    pipeline::Shot shot;

    [[nodiscard]] std::int64_t frame_count() const;
    /// What a frame is rendered from, with the seed that a film gives it.
    [[nodiscard]] pipeline::FrameInputs inputs(std::int64_t frame) const;
    [[nodiscard]] render::Film render(std::int64_t frame) const;

  private:
    sim::Timeline timeline_;
};

}  // namespace carom::testing
