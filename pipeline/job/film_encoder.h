// The encoding side of a job: writes the pictures as a video.
#pragma once

#include <cstddef>
#include <functional>
#include <stop_token>

#include "pipeline/job/film_plan.h"
#include "pipeline/job/film_sink.h"
#include "pipeline/job/frame_queue.h"
#include "pipeline/job/thread_safe_observer.h"
#include "pipeline/store/frame_store.h"
#include "render/film/film.h"

namespace carom::pipeline {

/// Returns a picture of the plan, by its number, as it is stored. Throws Error, Stopped.
using PictureReader = std::function<render::Film(std::size_t picture)>;

/// Reads pictures from the store, each as soon as the queue announces it. Refers to its arguments.
[[nodiscard]] PictureReader stored_pictures(const FilmPlan& plan, const FrameStore& store,
                                            FrameQueue& queue, std::stop_token stop);

/// Passes the film's frames in order to the sink and finishes the sink. If the sink wants a
/// preview, all frames are passed twice. Throws Error, Stopped.
void encode_film(FilmSink& sink, const FilmPlan& plan, const PictureReader& read,
                 ThreadSafeObserver& observer, const std::stop_token& stop);

}  // namespace carom::pipeline
