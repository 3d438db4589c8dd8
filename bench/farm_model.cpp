#include "bench/farm_model.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "bench/farm_clock.h"
#include "bench/farm_frames.h"
#include "bench/farm_watch.h"
#include "core/splitmix.h"

namespace carom::bench {
namespace {

// More than a worker can have; keeps the random numbers of the workers apart.
constexpr std::uint64_t kTasksPerWorker = 1U << 20U;

/// A place in the farm. Its tasks follow each other, each on a node of its own.
struct Worker {
    int task = 0;  // how many have started or ended; an event of an earlier task is void
    bool is_running = false;
    double task_started = 0;
    double slowness = 1;
    int frame = -1;  // that it renders
    bool is_claiming = false;
    double render_started = 0;
    double render_seconds = 0;
    std::vector<int> order;  // of the film's frames: its own share first
    std::size_t position = 0;
    int claim_files = 0;
    double waiting_since = -1;  // -1: it is not waiting
    double poll = 0;
    ClaimWatch watch;
    SplitMix64 random{0};
};

/// Every `of`th frame from `number` on, then the rest, which each worker begins elsewhere.
std::vector<int> own_share_first(const std::vector<int>& order, int number, int of) {
    std::vector<int> own;
    std::vector<int> others;
    for (std::size_t i = 0; i < order.size(); ++i) {
        (static_cast<int>(i % of) == number ? own : others).push_back(order[i]);
    }
    const auto first = static_cast<std::ptrdiff_t>(number * others.size() / of);
    std::rotate(others.begin(), others.begin() + first, others.end());
    own.insert(own.end(), others.begin(), others.end());
    return own;
}

class Farm {
  public:
    Farm(const FarmSettings& settings, const std::vector<double>& frame_seconds)
        : settings_(settings),
          costs_(costs_of(settings.kind)),
          seconds_(frame_seconds),
          frames_(static_cast<int>(frame_seconds.size())),
          workers_(static_cast<std::size_t>(settings.workers)),
          clock_(settings.store) {
        std::vector<double> sorted = frame_seconds;
        std::sort(sorted.begin(), sorted.end());
        median_seconds_ = sorted[sorted.size() / 2];
    }

    FarmResult run() {
        for (int i = 0; i < settings_.workers; ++i) {
            after(i / settings_.starts_per_second, Step::start, i);
        }
        while (frames_.unfinished() > 0 && clock_.now() < settings_.give_up_after) {
            const Action action = clock_.next();
            if (action.task == worker(action.worker).task) {
                handle(action);
            }
        }
        return result();
    }

  private:
    Worker& worker(int index) { return workers_[static_cast<std::size_t>(index)]; }
    [[nodiscard]] bool is_listing() const { return settings_.search == Search::list; }

    [[nodiscard]] Action action(Step step, int index, int frame = -1) const {
        return {step, index, workers_[static_cast<std::size_t>(index)].task, frame};
    }

    void after(double seconds, Step step, int index, int frame = -1) {
        clock_.after(seconds, action(step, index, frame));
    }

    void ask(const Demand& demand, Step then, int index, int frame = -1) {
        clock_.ask(demand, action(then, index, frame));
    }

    void handle(const Action& action) {
        if (action.asked >= 0 && is_waited_for(action.step)) {
            result_.wait_seconds += clock_.now() - action.asked;
        }
        switch (action.step) {
            case Step::none:
                return;
            case Step::start:
                return start_task(action.worker);
            case Step::read:
                return after(settings_.load_seconds, Step::loaded, action.worker);
            case Step::note:
                return write_note(action.worker);
            case Step::noted:
                return after(settings_.note_seconds, Step::note, action.worker);
            case Step::loaded:
                return look(action.worker);
            case Step::looked:
                return looked(action.worker);
            case Step::tried:
                return tried(action.worker, action.frame);
            case Step::rendered:
                return rendered(action.worker);
            case Step::beat:
                return beat(action.worker, action.frame);
            case Step::beaten:
                return beaten(action.worker, action.frame);
            case Step::stored:
                return stored(action.worker);
            case Step::poll:
                return poll(action.worker);
            case Step::polled:
                return polled(action.worker);
            case Step::lost:
                return lose_node(action.worker);
            case Step::stop:
                return hand_over(action.worker);
        }
    }

    /// Whether the worker does nothing else meanwhile.
    [[nodiscard]] static bool is_waited_for(Step step) {
        return step == Step::read || step == Step::looked || step == Step::tried ||
               step == Step::stored || step == Step::polled;
    }

    void start_task(int index) {
        Worker& it = worker(index);
        const int task = it.task;
        it = Worker();
        it.task = task + 1;
        it.is_running = true;
        it.task_started = clock_.now();
        const auto place = static_cast<std::uint64_t>(index) * kTasksPerWorker + it.task;
        it.random = SplitMix64(split_mix(split_mix(settings_.seed) + place));
        const bool is_slow = it.random.next_unit() < settings_.slow_nodes;
        it.slowness = is_slow ? settings_.slow_factor : 1.0;
        result_.tasks += 1;
        plan_end(index);
        if (!is_listing()) {
            it.order = own_share_first(frames_.order(), index, settings_.workers);
        }
        Demand load = Demand::of(Verb::get, settings_.load_requests);
        load.bytes = settings_.load_bytes;
        if (!is_listing()) {
            load += claim_files_ * costs_.read_leftover;
        }
        ask(load, Step::read, index);
        write_note(index);
    }

    /// A worker tells about itself while it runs.
    void write_note(int index) {
        if (settings_.note_seconds > 0) {
            ask(costs_.note, Step::noted, index);
        }
    }

    void plan_end(int index) {
        const double chance = worker(index).random.next_unit();
        if (settings_.lost_nodes_per_hour > 0) {
            const double rate = -std::log1p(-settings_.lost_nodes_per_hour) / 3600;
            after(-std::log1p(-chance) / rate, Step::lost, index);
        }
        if (settings_.time_limit > 0) {
            after(settings_.time_limit, Step::stop, index);
        }
    }

    void end_task(int index, double delay) {
        Worker& it = worker(index);
        result_.worker_seconds += clock_.now() - it.task_started;
        it.is_running = false;
        claim_files_ -= it.claim_files;
        ++it.task;
        after(delay, Step::start, index);
    }

    [[nodiscard]] bool is_budget_used(int index) {
        return clock_.now() - worker(index).task_started >= settings_.budget;
    }

    /// Looks for a frame, or ends if the budget is used.
    void look(int index) {
        Worker& it = worker(index);
        if (is_budget_used(index)) {
            return end_task(index, settings_.next_task_delay);
        }
        if (is_listing()) {
            return ask(list(), Step::looked, index);
        }
        if (it.position == it.order.size()) {
            return wait(index);
        }
        ask(costs_.look, Step::looked, index);
    }

    void looked(int index) {
        Worker& it = worker(index);
        const int number = is_listing() ? choose_listed(index) : it.order[it.position++];
        if (number < 0) {
            return wait(index);
        }
        if (frames_[number].state == FrameState::done) {
            return look(index);
        }
        try_claim(index, number);
    }

    [[nodiscard]] Demand list() const {
        return (2 + frames_.count() / costs_.names_per_page) * costs_.list_page;
    }

    /// Workers that read the same list try different frames of it.
    [[nodiscard]] int choose_listed(int index) const {
        const std::vector<int> open = frames_.all_open();
        return open.empty() ? -1 : open[static_cast<std::size_t>(index) % open.size()];
    }

    void try_claim(int index, int number) {
        const bool is_open = frames_[number].state == FrameState::open;
        worker(index).is_claiming = is_open;
        ask(is_open ? costs_.claim : costs_.read_claim, Step::tried, index, number);
    }

    void tried(int index, int number) {
        if (frames_[number].state != FrameState::open) {
            result_.vain_claims += worker(index).is_claiming ? 1 : 0;
            return look(index);
        }
        claim(index, number);
    }

    void claim(int index, int number) {
        if (frames_[number].claims == 0) {
            result_.last_first_claim = clock_.now();
        } else if (frames_[number].work_left == 1) {
            result_.frames_again += 1;
        }
        frames_.claim(number, index, clock_.now());
        ++worker(index).claim_files;
        ++claim_files_;
        claim_load_.add(clock_.now(), clock_.now(), 1);
        render(index, number);
    }

    void render(int index, int number) {
        Worker& it = worker(index);
        it.frame = number;
        it.watch = ClaimWatch();
        it.waiting_since = -1;
        it.render_started = clock_.now();
        const double work = seconds_[static_cast<std::size_t>(number)] * frames_[number].work_left;
        it.render_seconds = work * it.slowness;
        after(it.render_seconds, Step::rendered, index);
        after(settings_.heartbeat, Step::beat, index, number);
    }

    void beat(int index, int number) {
        if (worker(index).frame == number) {
            ask(costs_.beat, Step::beaten, index, number);
        }
    }

    void beaten(int index, int number) {
        if (worker(index).frame == number) {
            frames_.beat(number, index, clock_.now());
            after(settings_.heartbeat, Step::beat, index, number);
        }
    }

    [[nodiscard]] Demand publishing() const {
        const double parts = costs_.bytes_per_request > 0
                                 ? std::ceil(settings_.frame_bytes / costs_.bytes_per_request)
                                 : 0;
        Demand demand = costs_.publish + Demand::of(Verb::get, parts);
        demand.bytes = settings_.frame_bytes;
        return demand;
    }

    void rendered(int index) { clock_.ask(publishing(), action(Step::stored, index)); }

    void stored(int index) {
        frames_.finish(worker(index).frame);
        worker(index).frame = -1;
        look(index);
    }

    void wait(int index) {
        Worker& it = worker(index);
        if (it.waiting_since < 0) {
            it.waiting_since = clock_.now();
            it.poll = settings_.poll;
        }
        poll(index);
    }

    void poll(int index) {
        Worker& it = worker(index);
        if (is_budget_used(index)) {
            return end_task(index, settings_.next_task_delay);
        }
        if (is_listing()) {
            it.watch.fill(frames_, settings_.watched_claims, it.random, clock_.now());
            return ask(list() + it.watch.count() * costs_.read_claim, Step::polled, index);
        }
        ask(frames_.unfinished() * (costs_.look + costs_.read_claim), Step::polled, index);
    }

    void polled(int index) {
        Worker& it = worker(index);
        if (const int number = is_listing() ? choose_listed(index) : frames_.first_open();
            number >= 0) {
            return try_claim(index, number);
        }
        if (const int number = dead_claim_seen_by(it); number >= 0) {
            ask(costs_.claim, Step::none, index);
            return claim(index, number);
        }
        if (const int number = slow_frame(); number >= 0) {
            frames_.start_backup(number, clock_.now());
            result_.frames_again += 1;
            return render(index, number);
        }
        after(it.poll, Step::poll, index);
        it.poll = std::max(settings_.poll, std::min(2 * it.poll, settings_.longest_poll));
    }

    /// A frame that takes so long that this worker renders it, too; -1 if there is none.
    [[nodiscard]] int slow_frame() const {
        if (settings_.backup_after <= 0) {
            return -1;
        }
        return frames_.not_begun_since(clock_.now() - settings_.backup_after * median_seconds_);
    }

    [[nodiscard]] int dead_claim_seen_by(Worker& it) {
        return is_listing() ? it.watch.read(frames_, settings_.expiry, clock_.now())
                            : dead_claim(frames_, it.waiting_since, settings_.expiry, clock_.now());
    }

    void lose_node(int index) {
        result_.lost_tasks += 1;
        end_task(index, settings_.requeue_delay);
    }

    /// The task is stopped: it stores the sums of its frame and removes its claim.
    void hand_over(int index) {
        const Worker& it = worker(index);
        if (it.frame >= 0) {
            clock_.ask(publishing(), action(Step::none, index));
            const double part = (clock_.now() - it.render_started) / it.render_seconds;
            frames_.hand_over(it.frame, index, std::min(part, 1.0));
        }
        end_task(index, settings_.next_task_delay);
    }

    FarmResult result() {
        for (const Worker& it : workers_) {
            result_.worker_seconds += it.is_running ? clock_.now() - it.task_started : 0;
        }
        result_.finished = clock_.now();
        const auto& requests = clock_.asked().requests;
        result_.lists = requests[static_cast<std::size_t>(Verb::list)];
        result_.heads = requests[static_cast<std::size_t>(Verb::head)];
        result_.gets = requests[static_cast<std::size_t>(Verb::get)];
        result_.puts = requests[static_cast<std::size_t>(Verb::put)];
        result_.peak_reads = clock_.peak_reads();
        result_.peak_writes = clock_.peak_writes();
        result_.peak_bytes = clock_.peak_bytes();
        result_.peak_claims = claim_load_.peak();
        result_.slowest_request = clock_.slowest_request();
        result_.unfinished = frames_.unfinished();
        return result_;
    }

    const FarmSettings& settings_;
    const ActionCosts& costs_;
    const std::vector<double>& seconds_;
    FarmFrames frames_;
    std::vector<Worker> workers_;
    FarmClock clock_;
    PeakPerSecond claim_load_;
    FarmResult result_;
    double median_seconds_ = 0;
    int claim_files_ = 0;  // a task removes its own when it ends
};

}  // namespace

FarmResult simulate_farm(const FarmSettings& settings, const std::vector<double>& frame_seconds) {
    return Farm(settings, frame_seconds).run();
}

}  // namespace carom::bench
