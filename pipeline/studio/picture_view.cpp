#include "pipeline/studio/picture_view.h"

#include <condition_variable>
#include <map>
#include <mutex>
#include <set>
#include <thread>
#include <utility>

#include "core/error.h"
#include "render/threads/thread_arena.h"

namespace carom::studio {
namespace {

constexpr int kSamplesBesideFilm = 16;

}  // namespace

class PictureView::State {
  public:
    State(Send send, PictureOptions options)
        : send_(std::move(send)),
          options_(std::move(options)),
          rounds_(options_.cache_folder),
          all_threads_(options_.threads),
          one_thread_(1),
          worker_([this](const std::stop_token& end) { work(end); }) {}

    /// Changes what is shown: the work on the old state ends, none of its pictures is sent.
    template <class Change>
    void change(const Change& change) {
        const std::lock_guard lock(mutex_);
        change(*this);
        restart_all();
    }

    void ask(PageId page, See see) {
        const std::lock_guard lock(mutex_);
        questions_[page] = {std::move(see), ++asked_, false};
        restart();
    }

    void cancel(PageId page) {
        const std::lock_guard lock(mutex_);
        if (questions_.erase(page) > 0 && busy_ && page == busy_with_) {
            restart();
        }
    }

    void cancel_all() {
        const std::lock_guard lock(mutex_);
        questions_.clear();
        restart();
    }

    void hold(Hold reason, bool is_on) {
        const std::lock_guard lock(mutex_);
        const bool was_held = !holds_.empty();
        is_on ? static_cast<void>(holds_.insert(reason)) : static_cast<void>(holds_.erase(reason));
        if (was_held != !holds_.empty()) {
            restart_all();
        }
    }

    void wait_until_idle() {
        std::unique_lock lock(mutex_);
        wake_.wait(lock, [&] { return !busy_ && next() == questions_.end(); });
    }

    PictureCounts counts() {
        const std::lock_guard lock(mutex_);
        return counts_;
    }

    ShownShot shown;
    bool film_running = false;

  private:
    struct Question {
        See see;
        std::uint64_t number = 0;  // in the order in which all pages asked
        bool is_answered = false;
    };
    using Questions = std::map<PageId, Question>;

    /// All questions are answered again. The mutex is held.
    void restart_all() {
        for (auto& [page, question] : questions_) {
            question.is_answered = false;
        }
        restart();
    }

    /// Ends the work on the old state. The mutex is held.
    void restart() {
        generation_ += 1;
        not_before_ = std::chrono::steady_clock::now() + options_.restart_delay;
        stop_.request_stop();
        wake_.notify_all();
    }

    /// The newest question that is to be answered now, or the end. The mutex is held.
    [[nodiscard]] Questions::iterator next() {
        auto newest = questions_.end();
        if (!shown.shot || !holds_.empty()) {
            return newest;
        }
        for (auto one = questions_.begin(); one != questions_.end(); ++one) {
            if (!one->second.is_answered &&
                (newest == questions_.end() || one->second.number > newest->second.number)) {
                newest = one;
            }
        }
        return newest;
    }

    void work(const std::stop_token& end) {
        const std::stop_callback stop_work(end, [this] {
            const std::lock_guard lock(mutex_);
            stop_.request_stop();
        });
        std::unique_lock lock(mutex_);
        while (wake_.wait(lock, end, [&] { return next() != questions_.end(); })) {
            if (end.stop_requested()) {
                return;
            }
            const auto begin = not_before_;
            if (std::chrono::steady_clock::now() < begin) {
                wake_.wait_until(lock, end, begin, [&] { return not_before_ != begin; });
                continue;
            }
            const auto& [page, question] = *next();
            busy_ = true;
            busy_with_ = page;
            stop_ = std::stop_source();
            const Job job{shown, page, question.see, film_running, generation_, stop_.get_token()};
            lock.unlock();
            answer(job);
            lock.lock();
            busy_ = false;
            if (generation_ == job.generation) {
                questions_.at(job.page).is_answered = true;
            }
            counts_ = rounds_.counts();
            wake_.notify_all();
        }
    }

    struct Job {
        ShownShot shown;
        PageId page;
        See question;
        bool beside_film;
        std::uint64_t generation;
        std::stop_token stop;
    };

    void answer(const Job& job) {
        render::ThreadArena& arena = job.beside_film ? one_thread_ : all_threads_;
        try {
            arena.execute([&] {
                rounds_.run(job.shown, job.question, job.beside_film ? kSamplesBesideFilm : 0,
                            job.stop, [&](Picture picture) { send(job, std::move(picture)); });
            });
        } catch (const Stopped&) {
            return;  // a change is waiting
        } catch (const std::exception& error) {
            Picture none;
            none.head.q = job.question.q;
            none.head.v = job.shown.v;
            none.problem = error.what();
            send(job, std::move(none));
        }
    }

    void send(const Job& job, Picture picture) {
        const std::lock_guard lock(mutex_);
        if (generation_ == job.generation) {
            send_(job.page, std::move(picture));
        }
    }

    Send send_;
    PictureOptions options_;
    PictureRounds rounds_;  // only the worker's
    render::ThreadArena all_threads_;
    render::ThreadArena one_thread_;
    std::mutex mutex_;  // of what follows, and of calls of send_
    std::condition_variable_any wake_;
    std::stop_source stop_;
    std::chrono::steady_clock::time_point not_before_;
    std::uint64_t generation_ = 0;
    std::set<Hold> holds_;
    Questions questions_;
    std::uint64_t asked_ = 0;
    bool busy_ = false;
    PageId busy_with_ = 0;
    PictureCounts counts_;
    std::jthread worker_;  // last: it ends before the rest
};

PictureView::PictureView(Send send, PictureOptions options)
    : state_(std::make_unique<State>(std::move(send), std::move(options))) {}

PictureView::~PictureView() = default;

void PictureView::set_shot(std::shared_ptr<const pipeline::Shot> shot,
                           std::shared_ptr<const sim::Timeline> timeline, std::int64_t version) {
    state_->change([&](State& state) {
        state.shown = {std::move(shot), std::move(timeline), version};
    });
}

void PictureView::ask(PageId page, See question) {
    state_->ask(page, std::move(question));
}

void PictureView::cancel(PageId page) {
    state_->cancel(page);
}

void PictureView::cancel_all() {
    state_->cancel_all();
}

void PictureView::hold(Hold reason, bool holds) {
    state_->hold(reason, holds);
}

void PictureView::set_film_running(bool running) {
    state_->change([&](State& state) { state.film_running = running; });
}

void PictureView::wait_until_idle() {
    state_->wait_until_idle();
}

PictureCounts PictureView::counts() const {
    return state_->counts();
}

}  // namespace carom::studio
