// Pictures in memory, for a film that is made without a store.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "pipeline/job/film_plan.h"
#include "render/film/film.h"

namespace carom::pipeline {

/// Keeps pictures that frames of a film need again, as far as they fit. If not all do, those are
/// dropped that are needed last. The film asks for its pictures in the order of its frames. For one
/// thread at a time.
class PictureMemory {
  public:
    /// The frames of the plan, which it refers to, are passed `passes` times. `limit`: bytes.
    PictureMemory(const FilmPlan& plan, std::size_t passes, std::uint64_t limit);

    /// A picture that was kept, or nothing.
    [[nodiscard]] std::optional<render::Film> find(std::size_t picture);

    /// Keeps a picture that is used now, if it is needed again.
    void keep(std::size_t picture, const render::Film& film);

  private:
    struct Kept {
        render::Film film;
        std::uint64_t bytes = 0;
    };

    void go_to(std::size_t picture);
    [[nodiscard]] bool shows(std::size_t step, std::size_t picture) const;
    /// The next step after this one that needs the picture; the number of steps if none does.
    [[nodiscard]] std::size_t next_use(std::size_t picture) const;
    void drop(std::size_t picture);

    const FilmPlan& plan_;
    std::size_t steps_;  // frames of all passes
    std::uint64_t limit_;
    std::size_t step_ = 0;                             // now
    std::vector<std::vector<std::size_t>> frames_of_;  // of each picture, ascending
    std::map<std::size_t, Kept> kept_;
    std::uint64_t bytes_ = 0;
};

}  // namespace carom::pipeline
