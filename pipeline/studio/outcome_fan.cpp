#include "pipeline/studio/outcome_fan.h"

#include <algorithm>
#include <cmath>
#include <condition_variable>
#include <cstddef>
#include <map>
#include <mutex>
#include <numbers>
#include <optional>
#include <set>
#include <span>
#include <stop_token>
#include <string>
#include <thread>
#include <tuple>
#include <utility>
#include <variant>

#include "core/error.h"
#include "sim/bake.h"

namespace carom::studio {

namespace {

constexpr int kMostRuns = 16;
constexpr double kMostDistance = 0.01;            // m
constexpr double kMostAngle = 0.2;                // rad
constexpr std::uint64_t kMostSteps = 15'000'000;  // of one run
constexpr double kTolerance = 1e-3;               // of the paths, m
constexpr double kSampleStep = 0.02;              // s, between points of a path before thinning
constexpr std::size_t kMostPoints = 2'000;        // of one path

Vec3 turned(const Vec3& v, double angle) {
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    return {c * v.x - s * v.y, s * v.x + c * v.y, v.z};
}

const sim::Body* find_body(const sim::WorldDescription& world, const std::string& name) {
    const auto found = std::ranges::find(world.bodies, name, &sim::Body::name);
    return found == world.bodies.end() ? nullptr : &*found;
}

/// Where an object is without disturbances.
Vec3 place_of(const sim::WorldDescription& world, const sim::Timeline& timeline,
              const std::string& name, double time) {
    if (const sim::Track* track = timeline.find(name)) {
        return track->sample(time).position;
    }
    const sim::Body* body = find_body(world, name);
    return body == nullptr ? Vec3(0, 0, 0) : body->pose.position;
}

/// A strike at an object or a point becomes one in a direction, which is turned. One that a trigger
/// starts happens at other times in each run: it keeps its target.
void turn_strike(sim::Strike& strike, const sim::ForceEvent& event,
                 const sim::WorldDescription& world, const sim::Timeline& timeline, double turn) {
    if (strike.direction) {
        *strike.direction += turn;
        return;
    }
    if (event.trigger || (!strike.toward && !strike.toward_point)) {
        return;
    }
    const double time = event.time + event.after;
    const Vec3 from = place_of(world, timeline, event.object, time);
    const Vec3 to =
        strike.toward ? place_of(world, timeline, *strike.toward, time) : *strike.toward_point;
    if (std::hypot(to.x - from.x, to.y - from.y) > 0) {
        strike.direction = std::atan2(to.y - from.y, to.x - from.x) + turn;
        strike.toward.reset();
        strike.toward_point.reset();
    }
}

double distance_to(const Vec3& point, const Vec3& a, const Vec3& b) {
    const Vec3 line = b - a;
    const double square = line.dot(line);
    const double along = square > 0 ? std::clamp((point - a).dot(line) / square, 0.0, 1.0) : 0;
    return (point - (a + line * along)).length();
}

struct Point {
    double time = 0;
    Vec3 place{0, 0, 0};
};

/// Marks the points that a polyline needs to stay near all of them (Douglas and Peucker 1973).
void mark_needed(std::span<const Point> points, std::vector<bool>& needed) {
    std::vector<std::pair<std::size_t, std::size_t>> open{{0, points.size() - 1}};
    while (!open.empty()) {
        const auto [first, last] = open.back();
        open.pop_back();
        std::size_t farthest = first;
        double distance = kTolerance;
        for (std::size_t i = first + 1; i < last; ++i) {
            const double d = distance_to(points[i].place, points[first].place, points[last].place);
            if (d > distance) {
                distance = d;
                farthest = i;
            }
        }
        if (farthest != first) {
            needed[farthest] = true;
            open.emplace_back(first, farthest);
            open.emplace_back(farthest, last);
        }
    }
}

/// The path of an object; empty if it does not move.
std::vector<Point> path_of(const sim::Track& track) {
    const std::span<const sim::Key> keys = track.keys();
    const sim::Bounds bounds = track.position_bounds(keys.front().time, keys.back().time);
    if ((bounds.high - bounds.low).length() < kTolerance) {
        return {};
    }
    std::vector<Point> points;
    const double step = std::max(kSampleStep, (keys.back().time - keys.front().time) / kMostPoints);
    for (const sim::Key& key : keys) {
        for (double time = points.empty() ? key.time : points.back().time + step; time < key.time;
             time += step) {
            points.push_back({time, track.sample(time).position});
        }
        points.push_back({key.time, key.position});
    }
    std::vector<bool> needed(points.size(), false);
    needed.front() = needed.back() = true;
    mark_needed(points, needed);
    std::vector<Point> path;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (needed[i]) {
            path.push_back(points[i]);
        }
    }
    return path;
}

/// Whether the event is an outcome for people. Those of surfaces and of phases of motion are not.
bool is_outcome(const sim::Event& event) {
    const bool is_ground = event.b == "cloth" || event.b == "floor" || event.b == "pocket";
    return event.kind == sim::EventKind::potted || event.kind == sim::EventKind::off_table ||
           (event.kind == sim::EventKind::impact && !is_ground);
}

using OutcomeKey = std::tuple<sim::EventKind, std::string, std::string>;

OutcomeKey key_of(const sim::Event& event) {
    // A ball that is potted is potted, whichever pocket takes it. The order of names in an impact
    // does not matter.
    if (event.kind != sim::EventKind::impact) {
        return {event.kind, event.a, ""};
    }
    return {event.kind, std::min(event.a, event.b), std::max(event.a, event.b)};
}

struct Outcome {
    FanOutcome message;
    int last_run = -1;
};

void count(const sim::Event& event, int run, std::map<OutcomeKey, Outcome>& outcomes) {
    const auto [found, is_new] = outcomes.try_emplace(key_of(event));
    Outcome& outcome = found->second;
    FanOutcome& message = outcome.message;
    if (is_new) {
        message = {std::string(to_string(event.kind)),
                   event.a,
                   event.b,
                   phrase_of(event),
                   0,
                   event.time,
                   event.time};
    } else if (event.kind == sim::EventKind::potted && message.b != event.b) {
        message.b.clear();
        message.text = event.a + " is potted";
    }
    if (outcome.last_run != run) {  // only the first time in each run
        outcome.last_run = run;
        ++message.runs;
        message.first = std::min(message.first, event.time);
        message.last = std::max(message.last, event.time);
    }
}

}  // namespace

Disturbance disturbance_of(int run, const Fan& fan) {
    const double part = (run + 0.5) / fan.runs;
    const double around = 2 * std::numbers::pi * part;
    // The angles in an order in which neighbours are not near each other: every third one.
    const int stride = fan.runs % 3 == 0 ? (fan.runs % 5 == 0 ? 7 : 5) : 3;
    const double other = ((run * stride) % fan.runs + 0.5) / fan.runs;
    return {Vec2(std::cos(around), std::sin(around)) * fan.distance, (2 * other - 1) * fan.angle};
}

sim::WorldDescription disturbed(const sim::WorldDescription& world, const sim::Timeline& timeline,
                                const Disturbance& disturbance) {
    sim::WorldDescription result = world;
    std::set<std::string> struck;
    for (sim::ForceEvent& event : result.events) {
        if (auto* strike = std::get_if<sim::Strike>(&event.action)) {
            struck.insert(event.object);
            turn_strike(*strike, event, world, timeline, disturbance.turn);
        } else if (auto* impulse = std::get_if<sim::Impulse>(&event.action)) {
            impulse->newton_seconds = turned(impulse->newton_seconds, disturbance.turn);
        } else if (auto* force = std::get_if<sim::Force>(&event.action)) {
            force->newtons = turned(force->newtons, disturbance.turn);
        } else if (auto* velocity = std::get_if<sim::SetVelocity>(&event.action)) {
            if (velocity->linear) {
                velocity->linear = turned(*velocity->linear, disturbance.turn);
            }
        }
    }
    for (sim::Body& body : result.bodies) {
        if (body.kind != sim::BodyKind::dynamic) {
            continue;
        }
        body.velocity = turned(body.velocity, disturbance.turn);
        if (struck.contains(body.name)) {
            body.pose.position.x += disturbance.displacement.x;
            body.pose.position.y += disturbance.displacement.y;
        }
    }
    return result;
}

Numbers<FanHead> fan_message(const std::vector<sim::Timeline>& runs) {
    Numbers<FanHead> message;
    std::map<OutcomeKey, Outcome> outcomes;
    for (std::size_t run = 0; run < runs.size(); ++run) {
        for (const sim::Track& track : runs[run].tracks) {
            const std::vector<Point> path = path_of(track);
            if (path.empty()) {
                continue;
            }
            message.head.tracks.push_back({track.name(), static_cast<int>(run),
                                           static_cast<std::int64_t>(message.numbers.size()),
                                           static_cast<std::int64_t>(path.size())});
            for (const Point& point : path) {
                message.numbers.insert(message.numbers.end(),
                                       {point.time, point.place.x, point.place.y, point.place.z});
            }
        }
        for (const sim::Event& event : runs[run].events) {
            if (is_outcome(event)) {
                count(event, static_cast<int>(run), outcomes);
            }
        }
    }
    for (auto& [key, outcome] : outcomes) {
        message.head.outcomes.push_back(std::move(outcome.message));
    }
    std::ranges::stable_sort(message.head.outcomes, {}, &FanOutcome::first);
    message.head.finished = static_cast<int>(runs.size());
    return message;
}

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
