// Where a film's frames end up: a video, or one picture each.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "pipeline/job/film_plan.h"
#include "render/film/film.h"

namespace carom::pipeline {

/// Takes a film's frames in order. For one thread at a time.
class FilmSink {
  public:
    FilmSink() = default;
    virtual ~FilmSink() = default;
    FilmSink(const FilmSink&) = delete;
    FilmSink& operator=(const FilmSink&) = delete;

    /// Whether it has to see all frames before the first is added.
    [[nodiscard]] virtual bool wants_preview() const { return false; }
    /// A frame that will be added later, with the same arguments. Throws Error.
    virtual void preview(std::int64_t /*frame*/, const render::Film& /*picture*/,
                         bool /*same_as_before*/) {}

    /// `picture` as the store holds it; the same object as before if it shows the same. Throws
    /// Error.
    virtual void add(std::int64_t frame, const render::Film& picture, bool same_as_before) = 0;

    /// A video is put in its place. Throws Error.
    virtual void finish() = 0;
};

/// By the path: a video, or an image sequence (pipeline/video/image_sequence.h). Refers to its
/// arguments. Throws Error.
[[nodiscard]] std::unique_ptr<FilmSink> make_film_sink(const FilmSource& source,
                                                       const FilmPlan& plan,
                                                       const std::string& path);

}  // namespace carom::pipeline
