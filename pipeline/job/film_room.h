// The room that a film's frames need in the cache.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <stop_token>
#include <string>

#include "pipeline/job/film_job.h"
#include "pipeline/job/film_plan.h"
#include "pipeline/store/frame_store.h"
#include "pipeline/store/pins.h"

namespace carom::pipeline {

/// Protects a job's frames from being pruned and reserves room for those that are missing
/// (reservations.h), for as long as it exists. How large frames are is known from those of the film
/// that are stored; if there are none, as soon as the first one is. Until then the usual size is
/// reserved, but a lack of room is not an error. For one thread at a time. Refers to its arguments.
class FilmRoom {
  public:
    /// `on_wait`: that of RoomRequest.
    FilmRoom(const FilmPlan& plan, const FrameStore& store, const sim::Bake& bake, const Shot& shot,
             const FilmJobOptions& options, std::function<void(const std::string&)> on_wait);

    /// Throws NoRoom if it is known that the missing frames do not fit beside what other jobs have
    /// reserved. Throws Error, Stopped.
    void require(const std::stop_token& stop);

    /// Must be called after every picture (its number in the plan) that was rendered and stored.
    /// The first time it may throw like require().
    void on_picture_stored(std::size_t picture, const std::stop_token& stop);

  private:
    [[nodiscard]] std::uint64_t removable() const;

    const FilmPlan& plan_;
    const FrameStore& store_;
    std::string cache_folder_;
    std::uint64_t limit_;
    std::chrono::system_clock::time_point begin_;
    bool is_measured_ = false;
    std::uint64_t bytes_each_ = 0;
    Pin pin_;
    std::function<void(const std::string&)> on_wait_;
};

}  // namespace carom::pipeline
