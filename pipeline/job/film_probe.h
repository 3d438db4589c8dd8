// The frames of a film that a forecast measures, and the blocks of pixels rendered of them.
#pragma once

#include <cstdint>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "pipeline/job/film_plan.h"
#include "render/frame/frame_probe.h"

namespace carom::pipeline {

/// Pictures that follow each other in the film, of one camera.
struct ProbeSite {
    std::size_t camera = 0;             // index in FilmProbe::cameras()
    std::vector<std::size_t> pictures;  // in the plan
};

/// The pictures to render that a camera films.
struct ProbeCamera {
    std::string name;
    std::vector<std::size_t> pictures;  // in the plan, ascending
};

/// What was measured of a site.
struct SiteMeasurement {
    ProbeSite site;
    std::vector<render::FrameProbe> frames;         // the first ones of site.pictures
    std::vector<std::vector<render::Film>> blocks;  // of each frame: the same places of the film
    /// How many blocks all `frames` have.
    [[nodiscard]] std::size_t common_blocks() const;
};

/// CPU seconds that may be used: a part of what the film will take, but within these bounds.
struct CpuBudget {
    double least = 0;
    double most = 0;
};

/// Blocks of one size, and how many of them are measured of a frame.
struct BlockPlan {
    int size = 0;     // pixels a side
    int at_once = 0;  // rendered
    int fewest = 0;   // so that sizes can be scaled up
    int most = 0;     // more tell little that is new
};

/// Measures a film within a limit of CPU time. Refers to its arguments. For one thread.
class FilmProbe {
  public:
    /// `pictures`: those of the plan that must be rendered, ascending.
    FilmProbe(const FilmSource& source, const FilmPlan& plan,
              const std::vector<std::size_t>& pictures);

    /// Measures until `limit` is requested, or earlier if the times are certain. `sequences`:
    /// whether several pictures in a row are wanted, for the size of the film. Throws Error.
    void measure(const render::PreparedScene& scene, bool sequences, const CpuBudget& allowed,
                 const std::stop_token& limit);

    /// Of the blocks, pixels a side.
    [[nodiscard]] int block_size() const { return plan_of_blocks_.size; }

    [[nodiscard]] const std::vector<ProbeCamera>& cameras() const { return cameras_; }
    /// Of those sites of which at least one block was measured.
    [[nodiscard]] const std::vector<SiteMeasurement>& sites() const { return sites_; }

  private:
    void choose_sites();
    bool open_frame(SiteMeasurement& site, const render::PreparedScene& scene);
    [[nodiscard]] double film_seconds() const;
    double scout(const render::PreparedScene& scene, const CpuBudget& allowed,
                 const std::stop_token& limit);
    void extend_sequences(const render::PreparedScene& scene, std::size_t frames,
                          const std::stop_token& limit);
    void add_blocks(SiteMeasurement& site, int count, const std::stop_token& limit);

    const FilmSource& source_;
    const FilmPlan& plan_;
    std::vector<ProbeCamera> cameras_;
    std::vector<SiteMeasurement> sites_;
    BlockPlan plan_of_blocks_;
    double per_frame_ = 0;  // s, of the fewest blocks
};

/// Blocks side by side, in rows of `columns`. All blocks have the same size and channels.
[[nodiscard]] render::Film mosaic_of(const std::vector<render::Film>& blocks, std::size_t columns);

}  // namespace carom::pipeline
