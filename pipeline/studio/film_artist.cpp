#include "pipeline/studio/film_artist.h"

#include <algorithm>
#include <exception>
#include <iterator>
#include <utility>
#include <variant>

#include "pipeline/studio/film_thumbnails.h"
#include "pipeline/studio/sequence_thumbnails.h"

namespace carom::studio {
namespace {

constexpr std::int64_t kMostThumbnails = 600;

/// The pictures of some of the frames of a film, evenly chosen. The film does not need them: what
/// fails ends them.
class SomeThumbnails {
  public:
    SomeThumbnails(const PreparedFilm& film, const std::string& cache_folder)
        : film_(film),
          cache_folder_(cache_folder),
          every_(std::max<std::int64_t>(1, std::ssize(film.frames) / kMostThumbnails)) {}

    /// For each frame, one after the other; empty: it gets none.
    std::optional<std::string> jpeg(std::int64_t frame) {
        if (count_++ % every_ != 0 || failed_) {
            return std::nullopt;
        }
        try {
            return drawn(frame);
        } catch (const std::exception&) {
            failed_ = true;
            return std::nullopt;
        }
    }

  private:
    std::optional<std::string> drawn(std::int64_t frame) {
        if (const auto* sequence = std::get_if<pipeline::Sequence>(&film_.content)) {
            if (!of_sequence_) {
                of_sequence_.emplace(*sequence, cache_folder_);
            }
            return of_sequence_->jpeg(frame);
        }
        if (!of_shot_) {
            const auto& [shot, source] = std::get<FilmedShot>(film_.content);
            of_shot_.emplace(shot, source, nullptr, cache_folder_);
        }
        return of_shot_->jpeg(frame);
    }

    const PreparedFilm& film_;
    const std::string& cache_folder_;
    std::int64_t every_;
    std::int64_t count_ = 0;
    bool failed_ = false;
    std::optional<FilmThumbnails> of_shot_;
    std::optional<SequenceThumbnails> of_sequence_;
};

}  // namespace

void FilmArtist::begin(int film) {
    const std::lock_guard lock(mutex_);
    film_ = film;
    frames_.clear();
    pictures_.clear();
    waiting_.clear();
}

void FilmArtist::add(FilmFrame frame) {
    const std::lock_guard lock(mutex_);
    waiting_.push_back(std::move(frame));
    added_.notify_all();
}

/// Waits for a frame to draw; empty: there is none any more.
std::optional<FilmFrame> FilmArtist::next(const std::stop_token& ended,
                                          const std::stop_token& cancelled) {
    std::unique_lock lock(mutex_);
    added_.wait(lock, ended, [&] { return !waiting_.empty(); });
    if (waiting_.empty() || cancelled.stop_requested()) {
        return std::nullopt;
    }
    FilmFrame frame = std::move(waiting_.front());
    waiting_.pop_front();
    return frame;
}

void FilmArtist::draw(const PreparedFilm& film, const std::stop_token& ended,
                      const std::stop_token& cancelled) {
    SomeThumbnails thumbnails(film, cache_folder_);
    while (std::optional<FilmFrame> frame = next(ended, cancelled)) {
        std::optional<std::string> bytes = thumbnails.jpeg(frame->frame);
        const std::lock_guard lock(mutex_);
        if (bytes) {
            frame->address = "/film_frame/" + std::to_string(film_) + "/" +
                             std::to_string(frame->frame) + ".jpg";
            pictures_[frame->address] = std::make_shared<const std::string>(std::move(*bytes));
        }
        frames_[frame->frame] = *frame;
        send_(0, *frame);
    }
}

void FilmArtist::tell(PageId page) {
    const std::lock_guard lock(mutex_);
    for (const auto& [number, frame] : frames_) {
        send_(page, frame);
    }
}

std::optional<Download> FilmArtist::find(std::string_view address) {
    const std::lock_guard lock(mutex_);
    const auto found = pictures_.find(address);
    return found == pictures_.end() ? std::nullopt
                                    : std::optional(Download{"image/jpeg", found->second, {}});
}

}  // namespace carom::studio
