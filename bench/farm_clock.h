// The course of a simulated farm: what its workers do next, and what its store answers when.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <queue>
#include <vector>

#include "bench/farm_store.h"

namespace carom::bench {

enum class Step {
    none,
    start,
    read,
    note,
    noted,
    loaded,
    looked,
    tried,
    rendered,
    beat,
    beaten,
    stored,
    poll,
    polled,
    lost,
    stop
};

/// What a worker does next. An action of an earlier task of the worker is void.
struct Action {
    Step step = Step::none;
    int worker = 0;
    int task = 0;
    int frame = -1;
};

/// How much is asked of the store, one request after another and then the bytes.
struct Demand {
    double requests = 0;
    double bytes = 0;
};

class FarmClock {
  public:
    explicit FarmClock(const StoreSettings& store)
        : requests_(1 / store.latency, store.requests_per_second),
          bytes_(store.client_bytes_per_second, store.bytes_per_second) {}

    /// s since the submission.
    [[nodiscard]] double now() const { return now_; }

    void after(double seconds, const Action& action) {
        events_.push({now_ + seconds, ++event_number_, action});
    }

    void ask(const Demand& demand, const Action& then) {
        requests_.start(now_, demand.requests, {demand.bytes, then});
    }

    /// Waits for the next event or answer. There must be one.
    Action next() {
        const double event = events_.empty() ? kNever : events_.top().time;
        const double answer = requests_.next();
        const double transferred = bytes_.next();
        now_ = std::min({event, answer, transferred});
        if (event == now_) {
            const Action action = events_.top().action;
            events_.pop();
            return action;
        }
        if (transferred == now_) {
            return bytes_.finish();
        }
        const Question question = requests_.finish();
        if (question.bytes > 0) {
            bytes_.start(now_, question.bytes, question.then);
            return {};
        }
        return question.then;
    }

    [[nodiscard]] double requests() const { return requests_.total(); }
    [[nodiscard]] double peak_requests() const { return requests_.peak(); }
    [[nodiscard]] double peak_bytes() const { return bytes_.peak(); }
    /// The longest time that a request took, s.
    [[nodiscard]] double slowest_request() const { return 1 / requests_.slowest_speed(); }

  private:
    struct Question {
        double bytes = 0;
        Action then;
    };

    struct Event {
        double time = 0;
        std::uint64_t number = 0;  // events of the same time keep their order
        Action action;

        bool operator>(const Event& other) const {
            return time != other.time ? time > other.time : number > other.number;
        }
    };

    SharedServer<Question> requests_;
    SharedServer<Action> bytes_;
    std::priority_queue<Event, std::vector<Event>, std::greater<>> events_;
    double now_ = 0;
    std::uint64_t event_number_ = 0;
};

}  // namespace carom::bench
