// Small frames of the example films, for tests of the dependences of their pixels.
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

    /// Tests may change it between frames, except the world and the cameras.
    pipeline::Shot shot;

    [[nodiscard]] std::int64_t frame_count() const;
    /// The inputs of a frame, with the seed that it has in a film.
    [[nodiscard]] pipeline::FrameInputs inputs(std::int64_t frame) const;
    [[nodiscard]] render::Film render(std::int64_t frame) const;

  private:
    sim::Timeline timeline_;
};

}  // namespace carom::testing
