// The encoding side of a job: from pictures to a video.
#pragma once

#include <stop_token>

#include "pipeline/job/film_plan.h"
#include "pipeline/job/film_sink.h"
#include "pipeline/job/frame_queue.h"
#include "pipeline/job/thread_safe_observer.h"
#include "pipeline/store/frame_store.h"

namespace carom::pipeline {

/// Takes the film's frames in order as soon as the queue announces them, always as the store holds
/// them, to the sink and finishes it; twice if the sink wants to see them before. Throws Error,
/// Stopped.
void encode_film(FilmSink& sink, const FilmPlan& plan, const FrameStore& store, FrameQueue& queue,
                 ThreadSafeObserver& observer, const std::stop_token& stop);

}  // namespace carom::pipeline
