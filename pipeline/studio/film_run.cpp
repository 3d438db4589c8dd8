#include "pipeline/studio/film_run.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <mutex>
#include <thread>
#include <utility>
#include <variant>
#include <vector>

#include "core/error.h"
#include "pipeline/store/cache_folder.h"
#include "pipeline/studio/child_program.h"
#include "pipeline/studio/film_artist.h"
#include "pipeline/studio/film_log.h"
#include "pipeline/studio/paths.h"
#include "pipeline/video/picture_kind.h"

namespace carom::studio {
namespace {

ProgramOptions with_cache_folder(ProgramOptions options) {
    if (options.cache_folder.empty()) {
        options.cache_folder = pipeline::default_cache_folder();
    }
    return options;
}

}  // namespace

class FilmRun::State {
  public:
    State(ProgramOptions options, Output output)
        : options_(with_cache_folder(std::move(options))),
          output_(std::move(output)),
          artist_(options_.cache_folder, output_.send) {}

    ~State() {
        stop();
        worker_.request_stop();
    }

    State(const State&) = delete;
    State& operator=(const State&) = delete;
    State(State&&) = delete;
    State& operator=(State&&) = delete;

    void start(PageId page, FilmRequest request) {
        {
            const std::lock_guard lock(mutex_);
            if (busy_) {
                throw Error("a film is being made already; stop it before you begin another one");
            }
            busy_ = true;
            stopping_ = false;
        }
        // Thumbnails of the last film may be under way: the new thread waits for their end.
        worker_.request_stop();
        worker_ = std::jthread([this, page, request = std::move(request),
                                last = std::move(worker_)](const std::stop_token& end) mutable {
            last = {};
            run(page, request, end);
        });
    }

    void stop() {
        const std::lock_guard lock(mutex_);
        stopping_ = busy_;
        if (child_ != nullptr) {
            child_->interrupt();
            if (state_.state == "running") {
                state_.state = "stopping";
                send_state();
            }
        }
    }

    void tell(PageId page) {
        const std::lock_guard lock(mutex_);
        if (!state_.state.empty()) {
            output_.send(page, state_);
        }
        artist_.tell(page);
    }

    std::optional<Download> find(std::string_view address) {
        {
            const std::lock_guard lock(mutex_);
            if (!state_.address.empty() && address == state_.address) {
                return Download{media_type_of(state_.output, "application/octet-stream"), nullptr,
                                state_.output};
            }
        }
        return artist_.find(address);
    }

  private:
    /// The output of the last film if that was stopped.
    [[nodiscard]] std::string stopped_output() {
        const std::lock_guard lock(mutex_);
        return state_.state == "stopped" ? state_.output : "";
    }

    void run(PageId page, const FilmRequest& request, const std::stop_token& end) {
        try {
            const std::variant<PreparedFilm, Exists> result =
                prepare_film(request, options_, stopped_output());
            if (const auto* film = std::get_if<PreparedFilm>(&result)) {
                output_.running(true);
                make(request, *film, end);
            } else {
                idle([&] { output_.send(page, std::get<Exists>(result)); });
            }
        } catch (const std::exception& error) {
            const std::string reason = error.what();
            idle([&] {
                if (state_.state == "running" || state_.state == "stopping") {
                    state_.state = "failed";
                    state_.message = reason;
                    send_state();
                }
                output_.send(page, Failed{StartFilm::kName, 0, reason});
            });
        }
    }

    /// Another film may begin, also for a page that has only just heard `news` of this one's end.
    void idle(const std::function<void()>& news) {
        output_.running(false);
        const std::lock_guard lock(mutex_);
        child_ = nullptr;
        busy_ = false;
        news();
    }

    /// Ends with idle(), unless it throws.
    void make(const FilmRequest& request, const PreparedFilm& film, const std::stop_token& end) {
        if (!begin(request, film)) {
            return idle([&] { finish(kInterrupted); });
        }
        for (const std::int64_t frame : frames_of_cards(film)) {
            artist_.add(FilmFrame{frame, false, 0, {}});
        }
        ChildProgram child(options_.program, film_words(request, options_, film.path));
        {
            const std::lock_guard lock(mutex_);
            child_ = &child;
            if (stopping_) {
                child.interrupt();
            }
        }
        const std::jthread artist(
            [&](const std::stop_token& ended) { artist_.draw(film, ended, end); });
        while (const std::optional<std::string> line = child.next_line()) {
            read(*line);
        }
        const int result = child.wait();
        idle([&] { finish(result); });  // before the last thumbnails
    }

    /// Those of the frames that show title cards alone, of which the log says nothing.
    static std::vector<std::int64_t> frames_of_cards(const PreparedFilm& film) {
        std::vector<std::int64_t> frames;
        const auto* sequence = std::get_if<pipeline::Sequence>(&film.content);
        if (sequence != nullptr) {
            std::ranges::copy_if(film.frames, std::back_inserter(frames), [&](std::int64_t frame) {
                return std::ranges::all_of(pipeline::layers_of(*sequence, frame),
                                           [&](const auto& layer) {
                                               return std::holds_alternative<pipeline::TitleCard>(
                                                   sequence->parts[layer.part].content);
                                           });
            });
        }
        return frames;
    }

    /// The pages hear of the film. Returns false if it was stopped already.
    bool begin(const FilmRequest& request, const PreparedFilm& film) {
        const std::lock_guard lock(mutex_);
        begin_ = std::chrono::steady_clock::now();
        state_ = first_state(request, film);
        film_ += 1;
        artist_.begin(film_);
        send_state();
        return !stopping_;
    }

    /// With the mutex. `result`: of the program.
    void finish(int result) {
        const std::string extension = pipeline::extension_of(state_.output);
        end_state(result, stopping_, "/film/" + std::to_string(film_) + extension, state_);
        send_state();
    }

    /// Reads a line of the log of `carom render`.
    void read(const std::string& line) {
        const std::lock_guard lock(mutex_);
        std::optional<FilmFrame> frame = read_log(line, stopping_, state_);
        send_state();
        if (frame) {
            artist_.add(std::move(*frame));
        }
    }

    /// With the mutex.
    void send_state() {
        const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin_;
        state_.seconds = elapsed.count();
        output_.send(0, state_);
    }

    ProgramOptions options_;
    Output output_;
    FilmArtist artist_;  // its mutex is taken after the one below

    std::mutex mutex_;       // of the members up to begin_
    bool busy_ = false;      // a film is being prepared or made
    bool stopping_ = false;  // it is to end
    ChildProgram* child_ = nullptr;
    int film_ = 0;  // number of the film
    FilmState state_;
    std::chrono::steady_clock::time_point begin_;

    std::jthread worker_;  // ends first; the program that it starts ends with it
};

FilmRun::FilmRun(ProgramOptions options, Output output)
    : state_(std::make_unique<State>(std::move(options), std::move(output))) {}

FilmRun::~FilmRun() = default;

void FilmRun::start(PageId page, const StartFilm& request, const std::string& shot,
                    const std::string& root) {
    state_->start(page, {request, shot, root});
}

void FilmRun::stop() {
    state_->stop();
}

void FilmRun::tell(PageId page) {
    state_->tell(page);
}

std::optional<Download> FilmRun::find(std::string_view address) const {
    return state_->find(address);
}

}  // namespace carom::studio
