#include "pipeline/job/film_room.h"

#include <utility>

#include "pipeline/job/forecast_sizes.h"
#include "pipeline/job/job_frames.h"
#include "pipeline/store/cache_maintenance.h"
#include "pipeline/store/reservations.h"

namespace carom::pipeline {
namespace {

// Times of the file system may be rounded to steps of 10 ms.
constexpr std::chrono::seconds kClockSlack{2};

// Frames of one film differ in size, and the first one may be larger than the others.
constexpr double kLeastPart = 0.75;

std::uint64_t usual_bytes(const Shot& shot) {
    const double pixels = static_cast<double>(shot.render.width) * shot.render.height;
    return static_cast<std::uint64_t>(pixels * usual_store_bytes_per_pixel(shot));
}

/// What the store has of a picture, also from before it was denoised; 0 if it is not there.
std::uint64_t bytes_of(const FilmPlan::Picture& picture, const FrameStore& store) {
    const std::uint64_t own = store.size_bytes(picture.key);
    const bool is_denoised = picture.key != picture.noisy_key;
    return own > 0 && is_denoised ? own + store.noisy_size_bytes(picture.noisy_key) : own;
}

}  // namespace

FilmRoom::FilmRoom(const FilmPlan& plan, const FrameStore& store, const sim::Bake& bake,
                   const Shot& shot, const FilmJobOptions& options,
                   std::function<void(const std::string&)> on_wait)
    : plan_(plan),
      store_(store),
      cache_folder_(cache_folder_of(options)),
      limit_(options.cache_limit),
      begin_(std::chrono::system_clock::now() - kClockSlack),
      bytes_each_(usual_bytes(shot)),
      pin_(cache_folder_, keys_of(plan, bake), bytes_each_),
      on_wait_(std::move(on_wait)) {
    std::uint64_t bytes = 0;
    std::uint64_t stored = 0;
    for (const FilmPlan::Picture& picture : plan.pictures) {
        const std::uint64_t size = bytes_of(picture, store);
        bytes += size;
        stored += size > 0 ? 1 : 0;
    }
    if (stored > 0) {
        is_measured_ = true;
        bytes_each_ = bytes / stored;
    }
}

// Nothing of this film, which is used now.
std::uint64_t FilmRoom::removable() const {
    if (limit_ == kNoLimit) {
        return 0;
    }
    std::uint64_t needed = 0;
    for (const FilmPlan::Picture& picture : plan_.pictures) {
        needed += store_.size_bytes(picture.key) > 0 ? 0 : bytes_each_;
    }
    PruneOptions options;
    options.limit = limit_ > needed ? limit_ - needed : 0;
    options.keep_since = begin_;
    options.dry_run = true;
    return prune_cache(cache_folder_, options).removed_bytes;
}

void FilmRoom::require(const std::stop_token& stop) {
    if (!is_measured_) {
        return;
    }
    bool is_complete = true;
    for (const FilmPlan::Picture& picture : plan_.pictures) {
        is_complete = is_complete && store_.contains(picture.key);
    }
    if (is_complete) {
        return;  // a job that only reads also works with a read-only cache
    }
    RoomRequest request{cache_folder_, pin_.name(), removable(), kLeastPart, {}, on_wait_};
    reserve_room(
        request, [this] { pin_.expect(bytes_each_); }, stop);
}

void FilmRoom::on_picture_stored(std::size_t picture, const std::stop_token& stop) {
    if (!is_measured_) {
        is_measured_ = true;
        bytes_each_ = bytes_of(plan_.pictures[picture], store_);
        require(stop);
    }
}

}  // namespace carom::pipeline
