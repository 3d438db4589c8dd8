// The encoding side of a job: writes the pictures as a video.
#pragma once

#include <stop_token>

#include "pipeline/job/film_plan.h"
#include "pipeline/job/film_sink.h"
#include "pipeline/job/frame_queue.h"
#include "pipeline/job/thread_safe_observer.h"
#include "pipeline/store/frame_store.h"

namespace carom::pipeline {

/// Passes the film's frames in order to the sink, each as soon as the queue announces it and always
/// as it is stored, and finishes the sink. If the sink wants a preview, all frames are passed
/// twice. Throws Error, Stopped.
void encode_film(FilmSink& sink, const FilmPlan& plan, const FrameStore& store, FrameQueue& queue,
                 ThreadSafeObserver& observer, const std::stop_token& stop);

}  // namespace carom::pipeline
