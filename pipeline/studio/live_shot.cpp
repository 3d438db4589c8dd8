#include "pipeline/studio/live_shot.h"

#include <chrono>
#include <condition_variable>
#include <iterator>
#include <limits>
#include <mutex>
#include <stop_token>
#include <thread>
#include <utility>

#include "core/cpu_time.h"
#include "core/error.h"
#include "pipeline/check/motion_check.h"
#include "pipeline/job/film_job.h"
#include "pipeline/studio/motion_messages.h"
#include "pipeline/studio/shot_state.h"
#include "pipeline/studio/value_places.h"
#include "sim/bake.h"
#include "sim/billiards/table_memo.h"

namespace carom::studio {

namespace {

constexpr double kShortest = 0.1;  // s, a simulation runs at least so long
constexpr double kSlow = 0.3;      // s, a simulation that takes longer waits for the end of a drag

double steady_seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

}  // namespace

class LiveShot::Worker {
  public:
    Worker(LiveOptions options, LiveOutput output)
        : options_(std::move(options)), output_(std::move(output)) {
        if (!options_.clock) {
            options_.clock = steady_seconds;
        }
        if (!options_.bake) {
            options_.bake = sim::bake_within;
        }
        thread_ = std::jthread([this](const std::stop_token& end) { run(end); });
    }

    ~Worker() {
        thread_.request_stop();
        const std::lock_guard lock(mutex_);
        ends_ = true;
        running_.request_stop();
    }

    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;
    Worker(Worker&&) = delete;
    Worker& operator=(Worker&&) = delete;

    void offer(TextsOfVersion texts) {
        const std::lock_guard lock(mutex_);
        newest_ = texts;
        waiting_ = Request{std::move(texts), false};
        deferred_ = false;
        stop_for_newer();
        wake_.notify_one();
    }

    void set_dragging(bool on) {
        const std::lock_guard lock(mutex_);
        dragging_ = on;
        if (!on && deferred_ && !waiting_) {
            waiting_ = Request{newest_, false};
            deferred_ = false;
            wake_.notify_one();
        }
    }

    void simulate() {
        const std::lock_guard lock(mutex_);
        if (!newest_.shot.empty()) {
            waiting_ = Request{newest_, true};
            wake_.notify_one();
        }
    }

  private:
    struct Request {
        TextsOfVersion texts;
        bool unlimited = false;
    };

    void run(const std::stop_token& end) {
        for (;;) {
            Request request;
            {
                std::unique_lock lock(mutex_);
                if (!wake_.wait(lock, end, [&] { return waiting_.has_value(); }) || ends_) {
                    return;
                }
                request = std::move(*std::exchange(waiting_, {}));
            }
            try {
                answer(request);
            } catch (const Stopped&) {
                continue;
            } catch (const std::exception& error) {
                fail(request, error.what());
            }
        }
    }

    void fail(const Request& request, const std::string& message) {
        output_.text(Failed{"bake", request.texts.v, message});
        send_problems(request, true);
    }

    void answer(const Request& request) {
        const double start = thread_cpu_seconds();
        const std::int64_t v = request.texts.v;
        pipeline::LoadResult loaded = load(request.texts);
        output_.files(v, loaded.files, loaded.missing);
        problems_ = problem_messages(loaded.problems, loaded.files);
        send_problems(request, !loaded.shot);
        if (!loaded.shot) {
            return;
        }
        const auto shot = std::make_shared<const pipeline::Shot>(std::move(*loaded.shot));
        const Hash128 hash = sim::physics_hash(shot->world);
        const bool kept = timeline_.has_value() && hash == baked_;
        if (!kept && (!timeline_ || takes_long())) {
            show_at_rest(v, *shot, *loaded.source);
        }
        if (!kept && !simulate(request, *shot, hash)) {
            return;
        }
        sim::Bake bake;
        bake.timeline = *timeline_;
        pipeline::add_keyed_motions(bake, *shot);
        const auto timeline = std::make_shared<const sim::Timeline>(std::move(bake.timeline));
        send(v, *shot, *loaded.source, *timeline, kept, start);
        output_.shown(v, *shot);
        output_.answer({v, shot, loaded.source, timeline});
        add_motion_problems(request, *shot, loaded, *timeline);
    }

    void send(std::int64_t v, const pipeline::Shot& shot, const pipeline::ShotSource& source,
              const sim::Timeline& timeline, bool kept, double start) {
        ShotState state = shot_state(shot, source, timeline, options_.root);
        state.v = v;
        output_.text(std::move(state));
        Numbers<CamerasHead> cameras = cameras_message(shot, timeline);
        if (cameras.numbers != cameras_ || !has_cameras_) {  // the page keeps them
            has_cameras_ = true;
            cameras_ = cameras.numbers;
            cameras.head.v = v;
            output_.binary(std::move(cameras.head), std::move(cameras.numbers));
        }
        Numbers<TimelineHead> motion = timeline_message(timeline);
        motion.head.v = v;
        motion.head.kept = kept;
        motion.head.milliseconds = 1e3 * (thread_cpu_seconds() - start);
        output_.binary(std::move(motion.head), std::move(motion.numbers));
    }

    /// The page shows the shot before its motion is known: everything stands as at the start.
    void show_at_rest(std::int64_t v, const pipeline::Shot& shot,
                      const pipeline::ShotSource& source) {
        sim::Bake bake;
        bake.timeline.end_time = shot.world.duration;
        for (const sim::Body& body : shot.world.bodies) {
            if (body.kind == sim::BodyKind::dynamic) {
                sim::Key key;
                key.position = body.pose.position;
                key.orientation = body.pose.orientation;
                bake.timeline.tracks.emplace_back(body.name, std::vector<sim::Key>{key});
            }
        }
        pipeline::add_keyed_motions(bake, shot);
        ShotState state = shot_state(shot, source, bake.timeline, options_.root);
        state.v = v;
        output_.text(std::move(state));
        output_.shown(v, shot);
    }

    void send_problems(const Request& request, bool complete) {
        output_.text(Problems{request.texts.v, complete, problems_});
    }

    void add_motion_problems(const Request& request, const pipeline::Shot& shot,
                             const pipeline::LoadResult& loaded, const sim::Timeline& timeline) {
        if (has_newer()) {
            return;
        }
        std::vector<pipeline::Problem> found =
            pipeline::simulation_problems(timeline, loaded.source.get());
        for (auto* check : {&pipeline::cloth_problems, &pipeline::camera_problems}) {
            std::vector<pipeline::Problem> more = check(shot, loaded.source.get(), timeline);
            std::move(more.begin(), more.end(), std::back_inserter(found));
        }
        for (Problem& problem : problem_messages(found, loaded.files)) {
            problems_.push_back(std::move(problem));
        }
        send_problems(request, true);
    }

    /// Bakes the world into timeline_. False if it is left for later, which the page is told.
    bool simulate(const Request& request, const pipeline::Shot& shot, const Hash128& hash) {
        const std::int64_t v = request.texts.v;
        if (!request.unlimited && is_deferred()) {
            output_.text(Deferred{
                v, "dragging", "simulating this shot takes long; it follows when the drag ends"});
            return false;
        }
        if (!request.unlimited && too_long_ == hash) {
            return defer_to_button(request);
        }
        std::optional<sim::Timeline> timeline = bake(request, shot.world);
        if (!timeline) {
            too_long_ = hash;
            return defer_to_button(request);
        }
        timeline_ = std::move(timeline);
        baked_ = hash;
        return true;
    }

    bool defer_to_button(const Request& request) {
        output_.text(Deferred{request.texts.v, "limit",
                              "simulating this shot takes longer than happens by itself; start it "
                              "with the button"});
        send_problems(request, true);
        return false;
    }

    /// Empty if the simulation takes too many steps. Throws Stopped if newer texts wait.
    std::optional<sim::Timeline> bake(const Request& request, const sim::WorldDescription& world) {
        WorkContext context;
        double began = 0;
        {
            const std::lock_guard lock(mutex_);
            running_ = std::stop_source();
            if (ends_) {
                running_.request_stop();
            }
            began = began_ = options_.clock();
            is_baking_ = true;
            may_stop_ = !request.unlimited && !was_stopped_;
            context.stop = running_.get_token();
        }
        bool has_reported = false;
        std::int64_t looked_at = request.texts.v;
        context.progress = [&](double fraction) {
            if (request.unlimited) {
                stop_for_other_world(world, looked_at);
            } else {
                const std::lock_guard lock(mutex_);
                if (waiting_) {
                    stop_for_newer();
                }
            }
            if (options_.clock() - began > kSlow) {
                has_reported = true;
                output_.text(Work{"bake", request.texts.v, fraction});
            }
        };
        std::optional<sim::Timeline> timeline;
        bool stopped = false;
        try {
            timeline = options_.bake(
                request.unlimited ? std::numeric_limits<std::uint64_t>::max() : options_.most_steps,
                world, context);
        } catch (const Stopped&) {
            stopped = true;
        } catch (...) {
            end_bake(false, began, has_reported);
            throw;
        }
        end_bake(stopped, began, has_reported);
        if (stopped) {
            throw Stopped();
        }
        return timeline;
    }

    void end_bake(bool stopped, double began, bool has_reported) {
        {
            const std::lock_guard lock(mutex_);
            is_baking_ = false;
            was_stopped_ = stopped;
            is_slow_ = options_.clock() - began > kSlow;
        }
        if (has_reported) {
            output_.text(Work{});
        }
    }

    /// A simulation that the user asked for, which may take minutes, is stopped by texts with
    /// another world only: not by those that are being typed and have errors, nor by an edit of a
    /// camera. `looked_at`: the newest version that was compared.
    void stop_for_other_world(const sim::WorldDescription& world, std::int64_t& looked_at) {
        TextsOfVersion newer;
        {
            const std::lock_guard lock(mutex_);
            if (!waiting_ || waiting_->texts.v == looked_at) {
                return;
            }
            newer = waiting_->texts;
        }
        looked_at = newer.v;
        const pipeline::LoadResult loaded = load(newer);
        if (loaded.shot && sim::physics_hash(loaded.shot->world) != sim::physics_hash(world)) {
            const std::lock_guard lock(mutex_);
            running_.request_stop();
        }
    }

    pipeline::LoadResult load(const TextsOfVersion& texts) {
        return pipeline::load_shot(texts.shot, {.overrides = options_.overrides,
                                                .quality = options_.quality,
                                                .root = options_.root,
                                                .texts = texts.texts.get(),
                                                .most_asset_bytes = options_.most_asset_bytes,
                                                .tables = &tables_});
    }

    /// Stops the simulation that runs if that is allowed. The mutex is locked.
    void stop_for_newer() {
        if (is_baking_ && may_stop_ && options_.clock() - began_ > kShortest) {
            running_.request_stop();
        }
    }

    [[nodiscard]] bool has_newer() {
        const std::lock_guard lock(mutex_);
        return waiting_.has_value() || ends_;
    }

    [[nodiscard]] bool takes_long() {
        const std::lock_guard lock(mutex_);
        return is_slow_;
    }

    /// Whether the shot has to wait for the end of the drag.
    [[nodiscard]] bool is_deferred() {
        const std::lock_guard lock(mutex_);
        deferred_ = dragging_ && is_slow_ && timeline_.has_value();
        return deferred_;
    }

    LiveOptions options_;
    LiveOutput output_;

    std::mutex mutex_;  // of the members up to is_slow_
    std::condition_variable_any wake_;
    std::optional<Request> waiting_;
    TextsOfVersion newest_;
    bool ends_ = false;
    bool dragging_ = false;
    bool deferred_ = false;  // the newest texts wait for the end of the drag
    std::stop_source running_;
    bool is_baking_ = false;
    bool may_stop_ = true;
    bool was_stopped_ = false;  // the last simulation
    double began_ = 0;
    bool is_slow_ = false;  // the last simulation

    // Of the thread.
    sim::billiards::TableMemo tables_;
    std::vector<Problem> problems_;
    std::optional<sim::Timeline> timeline_;  // without keyed motions
    std::vector<double> cameras_;            // as they were last sent
    bool has_cameras_ = false;
    Hash128 baked_;
    std::optional<Hash128> too_long_;

    std::jthread thread_;
};

LiveShot::LiveShot(LiveOptions options, LiveOutput output)
    : worker_(std::make_unique<Worker>(std::move(options), std::move(output))) {}

LiveShot::~LiveShot() = default;

void LiveShot::offer(TextsOfVersion texts) {
    worker_->offer(std::move(texts));
}

void LiveShot::set_dragging(bool on) {
    worker_->set_dragging(on);
}

void LiveShot::simulate() {
    worker_->simulate();
}

}  // namespace carom::studio
