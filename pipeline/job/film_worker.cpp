#include "pipeline/job/film_worker.h"

#include <algorithm>
#include <bit>
#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <numeric>
#include <tuple>

#include "core/assert.h"
#include "core/error.h"
#include "pipeline/job/cached_renderer.h"
#include "pipeline/job/job_frames.h"
#include "pipeline/store/wait_notice.h"

namespace carom::pipeline {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds kPollInterval{1};

/// Of the order every `of`th from `number` on, then the rest.
std::deque<std::size_t> own_share_first(const std::vector<std::size_t>& order, std::size_t number,
                                        std::size_t of) {
    std::deque<std::size_t> own;
    std::deque<std::size_t> others;
    for (std::size_t i = 0; i < order.size(); ++i) {
        // The rest is begun elsewhere, too.
        (i % of == number ? own : others).push_back(order[i]);
    }
    const std::size_t first = others.empty() ? 0 : number * others.size() / of;
    std::rotate(others.begin(), others.begin() + static_cast<std::ptrdiff_t>(first), others.end());
    own.insert(own.end(), others.begin(), others.end());
    return own;
}

void wait(std::chrono::milliseconds time, const std::stop_token& stop) {
    std::mutex mutex;
    std::condition_variable_any wake;
    std::unique_lock lock(mutex);
    wake.wait_for(lock, stop, time, [] { return false; });
}

/// A film while it is worked on.
struct Film {
    Film(const WorkerFilm& film, const std::stop_token& stop)
        : given(film),
          source(film.shot, film.bake.timeline),
          plan(plan_film(source, job_frames(film.shot, film.options), stop)) {}

    /// By picture, whether a frame of this kind shows it.
    template <class IsWanted>
    [[nodiscard]] std::vector<bool> shown_by(const IsWanted& is_wanted) const {
        std::vector<bool> shown(plan.pictures.size());
        for (std::size_t i = 0; i < plan.frames.size(); ++i) {
            if (is_wanted(plan.frames[i] + given.shift)) {
                shown[plan.picture_of[i]] = true;
                if (const FilmPlan::Blend* blend = plan.blend_of(i)) {
                    shown[blend->picture] = true;
                }
            }
        }
        return shown;
    }

    /// Lets all pictures wait that are wanted.
    void follow(const FrameWishes& wishes, const WorkerOptions& options) {
        const std::vector<bool> is_first =
            shown_by([&](std::int64_t frame) { return wishes.preferred.contains(frame); });
        const std::vector<bool> is_wanted =
            shown_by([&](std::int64_t frame) { return !wishes.skipped.contains(frame); });
        preferred.clear();
        waiting.clear();
        for (const std::size_t picture : own_share_first(bit_reversed_order(plan.pictures.size()),
                                                         options.number, options.of)) {
            if (is_wanted[picture]) {
                (is_first[picture] ? preferred : waiting).push_back(picture);
            }
        }
    }

    [[nodiscard]] bool waits() const { return !preferred.empty() || !waiting.empty(); }

    const WorkerFilm& given;
    FilmSource source;
    FilmPlan plan;
    std::deque<std::size_t> preferred;  // pictures
    std::deque<std::size_t> waiting;
};

class Worker {
  public:
    Worker(const std::vector<WorkerFilm>& films, const WorkerOptions& options,
           const FrameStore& store, ThreadSafeObserver& observer,
           const std::function<void(const WorkerState&)>& on_state, const std::stop_token& stop)
        : options_(options),
          store_(store),
          observer_(observer),
          end_(Clock::now() + std::chrono::duration_cast<Clock::duration>(options.budget)),
          on_state_(on_state) {
        for (const WorkerFilm& film : films) {
            films_.push_back(std::make_unique<Film>(film, stop));
            state_.pictures += std::ssize(films_.back()->plan.pictures);
        }
        look_at_wishes();
        follow_wishes();
    }

    WorkerResult run(const std::stop_token& stop) {
        while (!is_done() && Clock::now() < end_) {
            bool is_any = work_on(&Film::preferred, stop);
            is_any = work_on(&Film::waiting, stop) || is_any;
            if (has_changed_) {
                follow_wishes();
            } else if (!is_any && Clock::now() < end_) {
                tell(-1, 0);
                tell_whom();
                wait(kPollInterval, stop);
            }
            if (stop.stop_requested()) {
                throw Stopped();
            }
        }
        tell(-1, 0);
        return {state_, is_complete()};
    }

  private:
    [[nodiscard]] bool is_complete() const {
        return std::ranges::none_of(films_, [](const auto& film) { return film->waits(); });
    }

    /// Whether it is complete for the newest wishes, too.
    [[nodiscard]] bool is_done() {
        if (is_complete()) {
            looked_ = {};
            look_at_wishes();
        }
        if (has_changed_) {
            follow_wishes();
        }
        return is_complete();
    }

    [[nodiscard]] bool may_begin() {
        look_at_wishes();
        return !has_changed_ && Clock::now() < end_;
    }

    void look_at_wishes() {
        if (options_.wishes && Clock::now() - looked_ >= kPollInterval) {
            FrameWishes wishes = options_.wishes();
            has_changed_ = has_changed_ || wishes.revision != wishes_.revision;
            wishes_ = std::move(wishes);
            looked_ = Clock::now();
        }
    }

    void follow_wishes() {
        has_changed_ = false;
        state_.finished = 0;
        for (const auto& film : films_) {
            film->follow(wishes_, options_);
        }
    }

    /// Works on these pictures of all films. Returns whether any is there now.
    bool work_on(std::deque<std::size_t> Film::*pictures, const std::stop_token& stop) {
        bool is_any = false;
        for (const auto& film : films_) {
            // Again and again, as long as pictures arrive: others render this film, too.
            while (!((*film).*pictures).empty() && may_begin() &&
                   pass(*film, (*film).*pictures, stop)) {
                is_any = true;
            }
        }
        return is_any;
    }

    /// Tries each of these pictures once. Returns whether any is there now.
    bool pass(const Film& film, std::deque<std::size_t>& waiting, const std::stop_token& stop) {
        std::deque<std::size_t> left;
        bool is_any = false;
        while (!waiting.empty() && may_begin()) {
            if (stop.stop_requested()) {
                throw Stopped();
            }
            const std::size_t picture = waiting.front();
            if (render(film, picture, stop)) {
                is_any = true;
            } else {
                left.push_back(picture);
            }
            waiting.pop_front();
        }
        waiting.insert(waiting.begin(), left.begin(), left.end());
        return is_any;
    }

    /// Says for whom the worker waits, if it has for long.
    void tell_whom() {
        const auto waited = wait_.due();
        const auto film =
            std::ranges::find_if(films_, [](const auto& one) { return one->waits(); });
        if (waited && film != films_.end()) {
            const auto& [preferred, waiting] = std::tie((*film)->preferred, (*film)->waiting);
            const std::size_t first = (preferred.empty() ? waiting : preferred).front();
            const FilmPlan::Picture& picture = (*film)->plan.pictures[first];
            observer_.warning(
                renderer_for(**film).waiting_text(picture, picture.frame + (*film)->given.shift,
                                                  preferred.size() + waiting.size() - 1, *waited));
        }
    }

    /// One film at a time has its scene in memory.
    CachedRenderer& renderer_for(const Film& film) {
        if (prepared_ != &film) {
            renderer_.reset();
            const FilmJobOptions& options = film.given.options;
            renderer_ = std::make_unique<CachedRenderer>(film.source, store_,
                                                         renderer_of(film.given.shot, options),
                                                         options.keeps_sums, options.threads);
            prepared_ = &film;
        }
        return *renderer_;
    }

    /// Returns whether the picture is there now.
    bool render(const Film& film, std::size_t picture, const std::stop_token& stop) {
        const CachedRender result = attempt(film, film.plan.pictures[picture], stop);
        if (result.origin == RenderOrigin::claimed_elsewhere) {
            return false;
        }
        wait_.end();
        ++state_.finished;
        if (result.origin == RenderOrigin::rendered) {
            ++state_.rendered;
            state_.twice += result.twice ? 1 : 0;
            state_.continued += result.continued ? 1 : 0;
            tell(film.plan.pictures[picture].frame + film.given.shift, 1);
        }
        return true;
    }

    /// Renders the picture, unless it is there or others do, and tells what became of it.
    CachedRender attempt(const Film& film, const FilmPlan::Picture& picture,
                         const std::stop_token& stop) {
        const std::int64_t frame = picture.frame + film.given.shift;
        bool is_begun = false;
        WorkContext context;
        context.stop = stop;
        context.progress = [this, frame, &is_begun](double fraction) {
            const std::lock_guard lock(mutex_);
            is_begun = true;
            const auto now = Clock::now();
            if (now - told_ >= kPollInterval) {
                tell(frame, fraction);
            }
        };
        const Clock::time_point begin = Clock::now();
        const auto ended = [&](FrameAttempt::End end, const CachedRender& result,
                               const std::string& problem) {
            if (options_.on_attempt) {
                const std::chrono::duration<double> elapsed = Clock::now() - begin;
                options_.on_attempt({end, frame, picture.layer, elapsed.count(), result.twice,
                                     result.continued, problem});
            }
        };
        try {
            CachedRender result = renderer_for(film).render(picture, context);
            if (result.origin == RenderOrigin::rendered) {
                ended(FrameAttempt::End::rendered, result, "");
            }
            return result;
        } catch (const Stopped&) {
            if (is_begun) {
                ended(FrameAttempt::End::stopped, {}, "");
            }
            throw;
        } catch (const Error& error) {
            ended(FrameAttempt::End::failed, {}, error.what());
            throw;
        }
    }

    void tell(std::int64_t frame, double fraction) {
        told_ = Clock::now();
        state_.frame = frame;
        state_.fraction = fraction;
        state_.seconds_left = std::max(0.0, std::chrono::duration<double>(end_ - told_).count());
        if (on_state_) {
            on_state_(state_);
        }
    }

    const WorkerOptions& options_;
    const FrameStore& store_;
    ThreadSafeObserver& observer_;
    WaitNotice wait_;  // for frames of others
    Clock::time_point end_;
    const std::function<void(const WorkerState&)>& on_state_;
    std::vector<std::unique_ptr<Film>> films_;
    const Film* prepared_ = nullptr;
    std::unique_ptr<CachedRenderer> renderer_;
    std::mutex mutex_;  // progress is told by any thread
    WorkerState state_;
    Clock::time_point told_{};
    FrameWishes wishes_;
    bool has_changed_ = false;  // the wishes, since follow_wishes()
    Clock::time_point looked_{};
};

}  // namespace

std::vector<std::size_t> bit_reversed_order(std::size_t count) {
    std::vector<std::size_t> order;
    const std::size_t whole = std::bit_ceil(count);
    std::size_t reversed = 0;
    for (std::size_t i = 0; i < whole; ++i) {
        if (reversed < count) {
            order.push_back(reversed);
        }
        // Adds one at the left end, with the carry to the right.
        std::size_t bit = whole / 2;
        while (bit != 0 && (reversed & bit) != 0) {
            reversed ^= bit;
            bit /= 2;
        }
        reversed |= bit;
    }
    return order;
}

WorkerResult work_on_films(const std::vector<WorkerFilm>& films, const WorkerOptions& worker,
                           const JobObserver& observer,
                           const std::function<void(const WorkerState&)>& on_state,
                           const std::stop_token& stop) {
    CAROM_ASSERT(!films.empty());
    ThreadSafeObserver safe_observer(observer);
    DamageReport damages(safe_observer);
    const FrameStore store = open_store(films.front().options, damages);
    return Worker(films, worker, store, safe_observer, on_state, stop).run(stop);
}

WorkerResult work_on_film(const Shot& shot, const sim::Bake& bake, const FilmJobOptions& options,
                          const WorkerOptions& worker, const JobObserver& observer,
                          const std::function<void(const WorkerState&)>& on_state,
                          const std::stop_token& stop) {
    return work_on_films({{shot, bake, options}}, worker, observer, on_state, stop);
}

}  // namespace carom::pipeline
