#include "pipeline/studio/shot_solver.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <map>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>
#include <utility>

#include "core/error.h"
#include "pipeline/solve/explain.h"
#include "pipeline/solve/route.h"
#include "pipeline/solve/solver.h"
#include "pipeline/studio/fan_message.h"
#include "pipeline/studio/sought_strike.h"
#include "pipeline/studio/strike_judge.h"
#include "pipeline/variants/variants.h"
#include "sim/bake.h"

namespace carom::studio {

namespace {

namespace solve = pipeline::solve;
using Clock = std::chrono::steady_clock;

constexpr double kMostSeconds = 60;   // of a search
constexpr double kJudgeSeconds = 15;  // for the window, the chance and the map of one strike
constexpr double kAheadWithin = 0.1;  // m
constexpr double kHappening = 10;     // what a solution misses that does not even pot the ball

/// A stop that comes with another one, or after a time.
class StopAfter {
  public:
    StopAfter(double seconds, const std::stop_token& other)
        : with_(other, [this] { own_.request_stop(); }),
          thread_([this, seconds](const std::stop_token& end) {
              std::mutex mutex;
              std::unique_lock lock(mutex);
              std::condition_variable_any wake;
              wake.wait_for(lock, end, std::chrono::duration<double>(seconds),
                            [] { return false; });
              if (!end.stop_requested()) {
                  own_.request_stop();
              }
          }) {}

    [[nodiscard]] std::stop_token token() const { return own_.get_token(); }

  private:
    std::stop_source own_;
    std::stop_callback<std::function<void()>> with_;
    std::jthread thread_;  // ends first
};

/// A solution as the page gets it.
struct Shown {
    ShotSolution message;
    sim::Strike strike;
    std::vector<FanTrack> tracks;
    std::vector<double> numbers;
};

auto rank_of(const ShotSolution& one) {
    return solve::rank_of(one.miss, one.route, one.chance);
}

/// Whether all but the place is as it is wanted.
bool is_potted(const solve::Solution& solution) {
    return solution.miss < kHappening;
}

ShotSolution message_of(const solve::Solution& solution, const std::string& ball) {
    ShotSolution message;
    message.route = solution.route;
    for (const sim::Event& event : solution.outcome.events) {
        if (event.kind == sim::EventKind::potted && event.a == ball) {
            message.pocket = event.b;
        }
    }
    message.is_solved = solution.is_solved;
    message.miss = solution.miss;
    message.chance = solution.chance;
    message.chance_error = solution.chance_error;
    message.window = solution.window_width();
    message.direction = solution.strike.direction.value_or(0);
    message.is_ball_speed = solution.strike.ball_speed.has_value();
    message.speed = solution.strike.ball_speed.value_or(solution.strike.speed.value_or(0));
    message.elevation = solution.strike.elevation;
    message.tip = {solution.strike.tip.x, solution.strike.tip.y};
    if (solution.rest) {
        message.rest = {solution.rest->x, solution.rest->y};
    }
    return message;
}

/// The paths of what moves from the strike on.
void add_motion(const sim::Trials& trials, const SoughtStrike& sought, const sim::Strike& strike,
                const std::stop_token& stop, Shown& shown) {
    std::vector<sim::ForceEvent> events = sought.world.events;
    events[sought.event].action = strike;
    sim::TrialLimits limits;
    limits.keeps_motion = true;
    limits.stop = stop;
    const std::optional<sim::Outcome> outcome = trials.run(std::move(events), limits);
    if (outcome && outcome->motion) {
        add_paths(*outcome->motion, sought.time, 0, shown.tracks, shown.numbers);
    }
}

std::string sentence(std::string text) {
    if (!text.empty() && text.front() >= 'a' && text.front() <= 'z') {
        text.front() = static_cast<char>(text.front() - 'a' + 'A');
    }
    return text + ".";
}

}  // namespace

class ShotSolver::Worker {
  public:
    Worker(SendNumbers answer, Send send) : answer_(std::move(answer)), send_(std::move(send)) {
        thread_ = std::jthread([this](const std::stop_token& end) { run(end); });
    }

    ~Worker() {
        thread_.request_stop();
        cancel(0);
    }

    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;
    Worker(Worker&&) = delete;
    Worker& operator=(Worker&&) = delete;

    void set_shot(std::shared_ptr<const pipeline::Shot> shot,
                  std::shared_ptr<const sim::Timeline> timeline, std::int64_t v) {
        const std::lock_guard lock(mutex_);
        shot_ = std::move(shot);
        timeline_ = std::move(timeline);
        v_ = v;
        wake_.notify_one();
    }

    void ask(PageId page, const Question& question) {
        const std::lock_guard lock(mutex_);
        questions_[page] = {question, Clock::now()};
        stop_work_for(is_ahead_ ? at_work_for_ : page);
        wake_.notify_one();
    }

    void cancel(PageId page) {
        const std::lock_guard lock(mutex_);
        std::erase_if(questions_, [&](const auto& one) { return page == 0 || one.first == page; });
        stop_work_for(page);
    }

  private:
    struct Asked {
        Question question;
        Clock::time_point at;
    };

    struct Job {
        PageId page = 0;
        Asked asked;
        std::shared_ptr<const pipeline::Shot> shot;
        std::shared_ptr<const sim::Timeline> timeline;
        std::int64_t v = 0;
        std::stop_source stop;
    };

    /// A search that another question may go on with.
    struct Kept {
        Hash128 hash;
        std::shared_ptr<const sim::Trials> trials;
        std::unique_ptr<solve::Solver> solver;  // null: only the trials
        SolveShot question;
        std::optional<solve::SolveResult> anywhere;  // what it finds without a place
    };

    /// With the mutex.
    void stop_work_for(PageId page) {
        if (page == 0 || page == at_work_for_) {
            running_.request_stop();
        }
    }

    /// With the mutex: the next question that can be answered.
    [[nodiscard]] auto next() {
        return std::ranges::find_if(questions_, [&](const auto& one) {
            return shot_ && std::visit([&](const auto& question) { return question.v <= v_; },
                                       one.second.question);
        });
    }

    void run(const std::stop_token& end) {
        for (;;) {
            Job job;
            {
                std::unique_lock lock(mutex_);
                if (!wake_.wait(lock, end, [&] { return next() != questions_.end(); }) ||
                    end.stop_requested()) {
                    return;
                }
                running_ = std::stop_source();
                is_ahead_ = false;
                const auto found = next();
                job = {found->first, found->second, shot_, timeline_, v_, running_};
                questions_.erase(found);
                at_work_for_ = job.page;
            }
            try {
                std::visit([&](const auto& question) { answer(job, question); },
                           job.asked.question);
            } catch (const Stopped&) {
                continue;
            } catch (const std::exception& error) {
                const char* name =
                    std::visit([](const auto& one) { return one.kName; }, job.asked.question);
                send(job, Failed{name, job.v, error.what()});
            }
        }
    }

    void send(const Job& job, const ServerMessage& message) {
        if (!job.stop.stop_requested()) {
            send_(job.page, message);
        }
    }

    // ---- strikes that are sought ----

    void answer(const Job& job, const SolveShot& question) {
        const SoughtStrike sought =
            sought_strike(*job.shot, *job.timeline, question.event, question.struck);
        keep_solver(sought, question);
        const StopAfter limit(std::clamp(question.seconds, 0.0, kMostSeconds),
                              job.stop.get_token());
        std::vector<Shown> list;
        solve::SolveWork work;
        work.parts.context.stop = limit.token();
        work.tells_nearest = question.rest.has_value();
        work.found = [&](const solve::Solution& solution) {
            if (is_potted(solution) && !job.stop.stop_requested() &&
                put(list, solution, sought, question)) {
                send_list(job, question, sought.time, list, {});
            }
        };
        // The solver answers without places only as long as it has wanted none.
        const bool is_known = !question.rest && kept_.anywhere;
        const solve::SolveResult result = is_known ? *kept_.anywhere : kept_.solver->solve(work);
        if (!question.rest && result.is_complete) {
            kept_.anywhere = result;
        }
        SolutionsHead last;
        last.complete = true;
        last.trials = static_cast<std::int64_t>(result.simulations);
        if (result.is_complete) {
            take_result(list, result, sought, question);
        }
        judge_all(list, job);
        if (list.empty() || !list.front().message.is_solved) {
            last.message = result.is_complete
                               ? sentence(solve::why_unsolved(sought.world, kept_problem_, result))
                               : "No strike that does this was found in " +
                                     std::to_string(static_cast<int>(question.seconds)) + " s.";
        }
        send_list(job, question, sought.time, list, std::move(last));
        if (!is_known && kept_.anywhere && !question.rest && !list.empty()) {
            work_ahead(job, sought, list.front().message);
        }
    }

    /// Places at rest are likely to be asked for next: what strikes bring about is learned
    /// meanwhile, until there is another question.
    void work_ahead(const Job& job, const SoughtStrike& sought, const ShotSolution& best) {
        {
            const std::lock_guard lock(mutex_);
            is_ahead_ = true;
            if (!questions_.empty()) {
                return;
            }
        }
        const auto [x, y] = best.rest.value_or(std::array<double, 2>{0, 0});
        kept_.solver->want_places({{sought.ball(), Vec2(x, y), kAheadWithin}});
        solve::SolveWork work;
        work.parts.context.stop = job.stop.get_token();
        static_cast<void>(kept_.solver->solve(work));
    }

    /// The solver of this question, or of one before that differs in the place alone.
    void keep_solver(const SoughtStrike& sought, const SolveShot& question) {
        keep_trials(sought);
        const SolveShot& known = kept_.question;
        if (!kept_.solver || known.event != question.event || known.ball != question.ball ||
            known.pocket != question.pocket) {
            kept_problem_ = pot_problem(sought, {{question.ball, question.pocket}});
            kept_.solver = std::make_unique<solve::Solver>(kept_.trials, kept_problem_);
            kept_.question = question;
            kept_.anywhere.reset();
        }
        std::vector<solve::RestPlace> places;
        if (question.rest) {
            const auto [x, y] = *question.rest;
            places.push_back({sought.ball(), Vec2(x, y), std::max(question.within, 1e-3)});
        }
        std::erase_if(kept_problem_.wants, [](const solve::Want& want) {
            return std::holds_alternative<solve::RestPlace>(want);
        });
        kept_problem_.wants.insert(kept_problem_.wants.end(), places.begin(), places.end());
        kept_.solver->want_places(std::move(places));
    }

    void keep_trials(const SoughtStrike& sought) {
        const Hash128 hash = sim::physics_hash(sought.world);
        if (!kept_.trials || kept_.hash != hash) {
            kept_ = {hash, std::make_shared<const sim::Trials>(sought.world), nullptr, {}, {}};
        }
    }

    /// Puts a solution into the list, in place of one with the same route; false: there are better
    /// ones. Of what misses the place only the nearest stays.
    bool put(std::vector<Shown>& list, const solve::Solution& solution, const SoughtStrike& sought,
             const SolveShot& question) {
        Shown shown{message_of(solution, question.ball), solution.strike, {}, {}};
        if (!solution.is_solved && !list.empty() &&
            rank_of(list.front().message) <= rank_of(shown.message)) {
            return false;
        }
        add_motion(*kept_.trials, sought, solution.strike, {}, shown);
        std::erase_if(list,
                      [&](const Shown& one) { return one.message.route == shown.message.route; });
        list.push_back(std::move(shown));
        std::ranges::stable_sort(list, {}, [](const Shown& one) { return rank_of(one.message); });
        const auto first_missed =
            std::ranges::find(list, false, [](const Shown& one) { return one.message.is_solved; });
        list.erase(list.begin() + std::max<std::ptrdiff_t>(first_missed - list.begin(), 1),
                   list.end());
        return true;
    }

    /// Exactly what the search found, in its order: of what does not meet all wants the nearest.
    void take_result(std::vector<Shown>& list, const solve::SolveResult& result,
                     const SoughtStrike& sought, const SolveShot& question) {
        std::vector<Shown> all;
        for (const solve::Solution& solution : result.solutions) {
            if (!solution.is_solved && (!all.empty() || !is_potted(solution))) {
                break;
            }
            const ShotSolution message = message_of(solution, question.ball);
            const auto same = std::ranges::find_if(list, [&](const Shown& one) {
                return one.message.route == message.route &&
                       one.message.direction == message.direction &&
                       one.message.speed == message.speed && one.message.tip == message.tip &&
                       one.message.elevation == message.elevation;
            });
            Shown shown{message, solution.strike, {}, {}};
            if (same != list.end()) {
                shown.tracks = std::move(same->tracks);
                shown.numbers = std::move(same->numbers);
            } else {
                add_motion(*kept_.trials, sought, solution.strike, {}, shown);
            }
            all.push_back(std::move(shown));
        }
        list = std::move(all);
    }

    /// Windows and chances of what was found shortly before the search ended.
    void judge_all(std::vector<Shown>& list, const Job& job) {
        pipeline::PartsWork work;
        work.context.stop = job.stop.get_token();
        pipeline::do_parts(
            list.size(),
            [&](std::size_t i) {
                ShotSolution& message = list[i].message;
                if (!message.is_solved || message.window > 0 || message.chance > 0) {
                    return;
                }
                const solve::Solution judged =
                    solve::Solver(kept_.trials, kept_problem_).judge(list[i].strike, work);
                message.window = judged.window_width();
                message.chance = judged.chance;
                message.chance_error = judged.chance_error;
            },
            work);
        std::ranges::stable_sort(list, {}, [](const Shown& one) { return rank_of(one.message); });
    }

    void send_list(const Job& job, const SolveShot& question, double time,
                   const std::vector<Shown>& list, SolutionsHead head) {
        head.q = question.q;
        head.v = job.v;
        head.time = time;
        for (std::size_t i = 0; i < job.shot->solved.size(); ++i) {
            if (job.shot->solved[i].event == static_cast<std::size_t>(question.event)) {
                head.solve_item = static_cast<int>(i);
            }
        }
        head.milliseconds =
            std::chrono::duration<double, std::milli>(Clock::now() - job.asked.at).count();
        std::vector<double> numbers;
        for (const Shown& one : list) {
            for (FanTrack track : one.tracks) {
                track.run = static_cast<int>(head.solutions.size());
                track.first += static_cast<std::int64_t>(numbers.size());
                head.tracks.push_back(std::move(track));
            }
            numbers.insert(numbers.end(), one.numbers.begin(), one.numbers.end());
            head.solutions.push_back(one.message);
        }
        if (!job.stop.stop_requested()) {
            answer_(job.page, head, numbers);
        }
    }

    // ---- a strike as it is ----

    void answer(const Job& job, const Judge& question) {
        const SoughtStrike sought = sought_strike(*job.shot, *job.timeline, question.event, {});
        keep_trials(sought);
        const StopAfter limit(kJudgeSeconds, job.stop.get_token());
        judge_strike({kept_.trials, sought, *job.timeline, question, job.v}, limit.token(),
                     [&](const ServerMessage& message) { send(job, message); });
    }

    SendNumbers answer_;
    Send send_;

    std::mutex mutex_;  // of the members up to running_
    std::condition_variable_any wake_;
    std::map<PageId, Asked> questions_;
    std::shared_ptr<const pipeline::Shot> shot_;
    std::shared_ptr<const sim::Timeline> timeline_;
    std::int64_t v_ = 0;
    PageId at_work_for_ = 0;
    bool is_ahead_ = false;  // of the questions: any of them ends the work
    std::stop_source running_;

    // Of the thread.
    Kept kept_;
    solve::SolveProblem kept_problem_;  // of kept_.solver, with the places of the question

    std::jthread thread_;  // ends first
};

ShotSolver::ShotSolver(SendNumbers answer, Send send)
    : worker_(std::make_unique<Worker>(std::move(answer), std::move(send))) {}

ShotSolver::~ShotSolver() = default;

void ShotSolver::set_shot(std::shared_ptr<const pipeline::Shot> shot,
                          std::shared_ptr<const sim::Timeline> timeline, std::int64_t v) {
    worker_->set_shot(std::move(shot), std::move(timeline), v);
}

void ShotSolver::ask(PageId page, const Question& question) {
    worker_->ask(page, question);
}

void ShotSolver::cancel(PageId page) {
    worker_->cancel(page);
}

}  // namespace carom::studio
