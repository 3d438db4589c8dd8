#include "pipeline/studio/outcome_fan.h"

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>
#include <utility>

#include "core/error.h"
#include "pipeline/studio/disturbance.h"
#include "pipeline/studio/fan_message.h"
#include "sim/bake.h"

namespace carom::studio {

namespace {

constexpr int kMostRuns = 16;
constexpr double kMostDistance = 0.01;            // m
constexpr double kMostAngle = 0.2;                // rad
constexpr std::uint64_t kMostSteps = 15'000'000;  // of one run

}  // namespace

class OutcomeFan::Worker {
  public:
    Worker(SendNumbers answer, Send failed)
        : answer_(std::move(answer)), failed_(std::move(failed)) {
        thread_ = std::jthread([this](const std::stop_token& end) { run(end); });
    }

    ~Worker() {
        thread_.request_stop();
        cancel();
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

    void ask(const Fan& question) {
        const std::lock_guard lock(mutex_);
        question_ = question;
        question_->runs = std::clamp(question.runs, 1, kMostRuns);
        question_->distance = std::clamp(question.distance, 0.0, kMostDistance);
        question_->angle = std::clamp(question.angle, 0.0, kMostAngle);
        running_.request_stop();
        wake_.notify_one();
    }

    void cancel() {
        const std::lock_guard lock(mutex_);
        question_.reset();
        running_.request_stop();
    }

  private:
    struct Job {
        Fan fan;
        std::shared_ptr<const pipeline::Shot> shot;
        std::shared_ptr<const sim::Timeline> timeline;
        std::int64_t v = 0;
        std::stop_token stop;
    };

    void run(const std::stop_token& end) {
        for (;;) {
            Job job;
            {
                std::unique_lock lock(mutex_);
                const auto is_ready = [&] { return question_ && shot_ && v_ >= question_->v; };
                if (!wake_.wait(lock, end, is_ready) || end.stop_requested()) {
                    return;
                }
                running_ = std::stop_source();
                job = {*std::exchange(question_, {}), shot_, timeline_, v_, running_.get_token()};
            }
            try {
                simulate(job);
            } catch (const Stopped&) {
                continue;
            } catch (const std::exception& error) {
                failed_(Failed{Fan::kName, job.v, error.what()});
            }
        }
    }

    void simulate(const Job& job) {
        std::vector<sim::Timeline> runs;
        for (int i = 0; i < job.fan.runs; ++i) {
            runs.push_back(bake(job, disturbance_of(i, job.fan)));
            Numbers<FanHead> message = fan_message(runs);
            message.head.v = job.v;
            message.head.runs = job.fan.runs;
            if (job.stop.stop_requested()) {
                throw Stopped();
            }
            answer_(message.head, message.numbers);
        }
    }

    static sim::Timeline bake(const Job& job, Disturbance disturbance) {
        const WorkContext context{.stop = job.stop};
        sim::WorldDescription world = disturbed(job.shot->world, *job.timeline, disturbance);
        if (!sim::find_problems(world).empty()) {
            // A ball that touches another one would overlap it: only the directions differ then.
            disturbance.displacement = {0, 0};
            world = disturbed(job.shot->world, *job.timeline, disturbance);
        }
        std::optional<sim::Timeline> timeline = sim::bake_within(kMostSteps, world, context);
        if (!timeline) {
            throw Error("this shot takes too long to be simulated several times");
        }
        return std::move(*timeline);
    }

    SendNumbers answer_;
    Send failed_;

    std::mutex mutex_;
    std::condition_variable_any wake_;
    std::optional<Fan> question_;
    std::shared_ptr<const pipeline::Shot> shot_;
    std::shared_ptr<const sim::Timeline> timeline_;
    std::int64_t v_ = 0;
    std::stop_source running_;

    std::jthread thread_;  // ends first
};

OutcomeFan::OutcomeFan(SendNumbers answer, Send failed)
    : worker_(std::make_unique<Worker>(std::move(answer), std::move(failed))) {}

OutcomeFan::~OutcomeFan() = default;

void OutcomeFan::set_shot(std::shared_ptr<const pipeline::Shot> shot,
                          std::shared_ptr<const sim::Timeline> timeline, std::int64_t v) {
    worker_->set_shot(std::move(shot), std::move(timeline), v);
}

void OutcomeFan::ask(const Fan& question) {
    worker_->ask(question);
}

void OutcomeFan::cancel() {
    worker_->cancel();
}

}  // namespace carom::studio
