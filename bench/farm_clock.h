// The course of a simulated farm: what its workers do next, and what its store answers when.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <queue>
#include <vector>

#include "bench/farm_requests.h"
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
    double asked = -1;  // s, when the worker asked the store for what it needs for this
};

class FarmClock {
  public:
    explicit FarmClock(const StoreSettings& store)
        : reads_(1 / store.latency, store.requests_per_second),
          writes_(1 / store.latency, store.writes_per_second),
          bytes_(store.client_bytes_per_second, store.bytes_per_second) {}

    /// s since the submission.
    [[nodiscard]] double now() const { return now_; }

    void after(double seconds, const Action& action) {
        events_.push({now_ + seconds, ++event_number_, action});
    }

    /// The requests that read come first, then those that write, then the bytes.
    void ask(const Demand& demand, Action then) {
        then.asked = now_;
        asked_ += demand;
        if (demand.reads() > 0) {
            reads_.start(now_, demand.reads(), {demand.writes(), demand.bytes, then});
        } else {
            writes_.start(now_, demand.writes(), {0, demand.bytes, then});
        }
    }

    /// Waits for the next event or answer. There must be one.
    Action next() {
        const double event = events_.empty() ? kNever : events_.top().time;
        const double read = reads_.next();
        const double written = writes_.next();
        const double transferred = bytes_.next();
        now_ = std::min({event, read, written, transferred});
        if (event == now_) {
            const Action action = events_.top().action;
            events_.pop();
            return action;
        }
        if (transferred == now_) {
            return bytes_.finish();
        }
        const Question question = read == now_ ? reads_.finish() : writes_.finish();
        if (question.writes > 0) {
            writes_.start(now_, question.writes, {0, question.bytes, question.then});
            return {};
        }
        if (question.bytes > 0) {
            bytes_.start(now_, question.bytes, question.then);
            return {};
        }
        return question.then;
    }

    /// All that was asked so far.
    [[nodiscard]] const Demand& asked() const { return asked_; }
    /// Requests of the busiest second.
    [[nodiscard]] double peak_reads() const { return reads_.peak(); }
    [[nodiscard]] double peak_writes() const { return writes_.peak(); }
    [[nodiscard]] double peak_bytes() const { return bytes_.peak(); }
    /// The longest time that a request took, s.
    [[nodiscard]] double slowest_request() const {
        return 1 / std::min(reads_.slowest_speed(), writes_.slowest_speed());
    }

  private:
    struct Question {
        double writes = 0;
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

    SharedServer<Question> reads_;
    SharedServer<Question> writes_;
    SharedServer<Action> bytes_;
    std::priority_queue<Event, std::vector<Event>, std::greater<>> events_;
    Demand asked_;
    double now_ = 0;
    std::uint64_t event_number_ = 0;
};

}  // namespace carom::bench
