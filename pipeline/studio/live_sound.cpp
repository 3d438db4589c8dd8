#include "pipeline/studio/live_sound.h"

#include <algorithm>
#include <cmath>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <optional>
#include <span>
#include <stop_token>
#include <thread>
#include <utility>
#include <vector>

#include "core/error.h"
#include "sound/sound_scene.h"

namespace carom::studio {

namespace {

void append_sample(std::string& bytes, double value) {
    const auto number =
        static_cast<std::uint16_t>(std::lround(std::clamp(value, -1.0, 1.0) * 32767));
    bytes.push_back(static_cast<char>(number & 0xffU));
    bytes.push_back(static_cast<char>(number >> 8U));
}

/// The next `count` samples, as 16-bit numbers of both channels by turns: silence after the end of
/// the source, which may be a film's music alone.
std::string next_piece(pipeline::SoundSource& source, std::size_t count,
                       const std::stop_token& stop) {
    constexpr std::size_t kBlock = 4096;
    std::vector<double> left(kBlock);
    std::vector<double> right(kBlock);
    std::string bytes;
    bool has_ended = false;
    while (count > 0) {
        if (stop.stop_requested()) {
            throw Stopped();
        }
        const std::size_t wanted = std::min(count, kBlock);
        std::size_t got = 0;
        if (!has_ended) {
            got = source.read(std::span(left).first(wanted), std::span(right).first(wanted));
            has_ended = got == 0;
        }
        if (has_ended) {
            left.assign(kBlock, 0);
            right.assign(kBlock, 0);
            got = wanted;
        }
        for (std::size_t i = 0; i < got; ++i) {
            append_sample(bytes, left[i]);
            append_sample(bytes, right[i]);
        }
        count -= got;
    }
    return bytes;
}

}  // namespace

class LiveSound::Worker {
  public:
    struct Film {
        int opening = 0;
        std::int64_t v = 0;
        Make make;
        std::stop_token stop;
    };

    Worker(Send send, const LiveSoundOptions& options) : send_(std::move(send)), options_(options) {
        thread_ = std::jthread([this](const std::stop_token& end) { run(end); });
    }

    ~Worker() {
        thread_.request_stop();
        clear();
    }

    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;
    Worker(Worker&&) = delete;
    Worker& operator=(Worker&&) = delete;

    void set(Film film) {
        const std::lock_guard lock(mutex_);
        waiting_ = std::move(film);
        running_.request_stop();
        wake_.notify_one();
    }

    void clear() {
        const std::lock_guard lock(mutex_);
        waiting_.reset();
        running_.request_stop();
        pieces_.clear();
    }

    [[nodiscard]] std::shared_ptr<const std::string> find(std::string_view path) const {
        const std::lock_guard lock(mutex_);
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            if (path == address_of(number_) + std::to_string(i) + ".pcm") {
                return pieces_[i];
            }
        }
        return nullptr;
    }

  private:
    static std::string address_of(int number) {
        return std::string(LiveSound::kFolder) + std::to_string(number) + "/";
    }

    void run(const std::stop_token& end) {
        while (std::optional<Film> film = next(end)) {
            try {
                compute(*film);
            } catch (const Stopped&) {
                continue;
            } catch (const std::exception& error) {
                tell_reason(*film, error.what());
            }
        }
    }

    /// Waits for a film that is the newest one for a while. Empty at the end.
    std::optional<Film> next(const std::stop_token& end) {
        std::unique_lock lock(mutex_);
        while (wake_.wait(lock, end, [&] { return waiting_.has_value(); })) {
            Film film = *std::exchange(waiting_, {});
            running_ = std::stop_source();
            const bool is_replaced = wake_.wait_for(lock, end, options_.rest, [&] {
                return waiting_.has_value() || running_.stop_requested();
            });
            if (end.stop_requested()) {
                break;
            }
            if (!is_replaced) {
                film.stop = running_.get_token();
                return film;
            }
        }
        return std::nullopt;
    }

    void compute(const Film& film) {
        const HeardFilm heard = film.make();
        const double seconds = static_cast<double>(heard.samples) / sound::kSampleRate;
        if (!heard.reason.empty()) {
            return tell_reason(film, heard.reason);
        }
        if (seconds > options_.most_seconds) {
            return tell_reason(film,
                               "the film is longer than the studio plays; 'carom sound' writes its "
                               "sound to a file");
        }
        const std::unique_ptr<pipeline::SoundSource> source = heard.make(film.stop);
        SoundState state{.v = film.v,
                         .rate = static_cast<int>(sound::kSampleRate),
                         .samples = heard.samples,
                         .piece = options_.piece};
        while (state.ready < state.samples) {
            const std::int64_t count = std::min(options_.piece, state.samples - state.ready);
            const auto bytes = std::make_shared<const std::string>(
                next_piece(*source, static_cast<std::size_t>(count), film.stop));
            state.address = add(film, bytes, state.ready == 0);
            state.ready += count;
            send_(film.opening, state);
        }
    }

    /// Keeps a piece; those of another film go before the first one. Returns the film's address.
    std::string add(const Film& film, std::shared_ptr<const std::string> piece, bool is_first) {
        const std::lock_guard lock(mutex_);
        if (film.stop.stop_requested()) {
            throw Stopped();
        }
        if (is_first) {
            pieces_.clear();
            ++number_;
        }
        pieces_.push_back(std::move(piece));
        return address_of(number_);
    }

    void tell_reason(const Film& film, const std::string& reason) {
        {
            const std::lock_guard lock(mutex_);
            if (film.stop.stop_requested()) {
                return;
            }
            pieces_.clear();
        }
        send_(film.opening, SoundState{.v = film.v, .reason = reason});
    }

    Send send_;
    LiveSoundOptions options_;

    mutable std::mutex mutex_;
    std::condition_variable_any wake_;
    std::optional<Film> waiting_;
    std::stop_source running_;
    int number_ = 0;  // of the film that the pieces are of
    std::vector<std::shared_ptr<const std::string>> pieces_;

    std::jthread thread_;  // ends first
};

LiveSound::LiveSound(Send send, const LiveSoundOptions& options)
    : worker_(std::make_unique<Worker>(std::move(send), options)) {}

LiveSound::~LiveSound() = default;

void LiveSound::set(int opening, std::int64_t v, Make make) {
    worker_->set({opening, v, std::move(make), {}});
}

void LiveSound::clear() {
    worker_->clear();
}

std::shared_ptr<const std::string> LiveSound::find(std::string_view path) const {
    return worker_->find(path);
}

}  // namespace carom::studio
