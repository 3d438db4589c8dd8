// Writes the frames of a film as a video or as one image file each.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "pipeline/job/film_job.h"
#include "pipeline/job/film_plan.h"
#include "pipeline/job/film_sound.h"
#include "pipeline/job/thread_safe_observer.h"
#include "render/film/film.h"

namespace carom::pipeline {

/// Receives the frames of a film in order. For one thread at a time.
class FilmSink {
  public:
    FilmSink() = default;
    virtual ~FilmSink() = default;
    FilmSink(const FilmSink&) = delete;
    FilmSink& operator=(const FilmSink&) = delete;

    /// Whether all frames must be passed to preview() before the first one is added.
    [[nodiscard]] virtual bool wants_preview() const { return false; }
    /// Receives a frame that will be added later, with the same arguments. Throws Error.
    virtual void preview(std::int64_t /*frame*/, const render::Film& /*picture*/,
                         bool /*same_as_before*/) {}

    /// Adds a frame. `picture` is as it is stored, and the same object as before if it shows the
    /// same. Throws Error.
    virtual void add(std::int64_t frame, const render::Film& picture, bool same_as_before) = 0;

    /// Moves a finished video to its final path. Throws Error.
    virtual void finish() = 0;
};

/// The path decides whether it is a video or an image sequence (pipeline/video/image_sequence.h).
/// The sink refers to its arguments. `threads` draw annotations; 0: one per processor. `sound` as
/// in FilmJobOptions: a video has that of its frames (sound_of_frames); beside an image sequence,
/// whose files have the numbers of the whole film, lies the sound of the whole film
/// (sound_path_of_sequence). Throws Error.
[[nodiscard]] std::unique_ptr<FilmSink> make_film_sink(const FilmSource& source,
                                                       const FilmPlan& plan,
                                                       const std::string& path, int threads,
                                                       const SoundMaker& sound = {});

/// What receives the frames of a job; null if nothing does. Warns if the film is silent although
/// there is a sound (silence_note). `stop` ends the computation of the sound. Throws Error.
[[nodiscard]] std::unique_ptr<FilmSink> sink_of(const FilmJobOptions& options,
                                                const FilmSource& source, const FilmPlan& plan,
                                                ThreadSafeObserver& observer,
                                                const std::stop_token& stop);

}  // namespace carom::pipeline
