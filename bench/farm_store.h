// The shared store of a simulated farm. It answers one request of each client after another and
// shares what it can do equally among the clients that are asking.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace carom::bench {

inline constexpr double kNever = std::numeric_limits<double>::infinity();

struct StoreSettings {
    double latency = 0.001;                // s from question to answer when the server is idle
    double requests_per_second = 0;        // what the server can do; 0 means any number. Objects:
    double writes_per_second = 0;          // of those that write; the others are those that read
    double bytes_per_second = 0;           // likewise
    double client_bytes_per_second = 1e9;  // what the network of one worker carries
};

/// The largest amount that came in one second.
class PeakPerSecond {
  public:
    /// Spreads the amount evenly over the interval. Intervals come in order of time.
    void add(double from, double to, double amount) {
        const auto first = static_cast<std::size_t>(from);
        const auto last = static_cast<std::size_t>(to);
        if (amounts_.size() <= last) {
            amounts_.resize(last + 1, 0.0);
        }
        if (first == last) {
            amounts_[first] += amount;
            return;
        }
        for (std::size_t second = first; second <= last; ++second) {
            const auto start = static_cast<double>(second);
            const double share = std::min(to, start + 1) - std::max(from, start);
            amounts_[second] += amount * share / (to - from);
        }
    }
    [[nodiscard]] double peak() const {
        return amounts_.empty() ? 0.0 : *std::max_element(amounts_.begin(), amounts_.end());
    }

  private:
    std::vector<double> amounts_;
};

/// A server whose clients each get `client_speed` (amounts per second) or, if that is more than
/// `capacity` together, equal parts of the capacity (0 = any). Known as egalitarian processor
/// sharing (Kleinrock 1967, "Time-shared systems: a theoretical treatment", J. ACM 14(2)).
template <typename Answer>
class SharedServer {
  public:
    SharedServer(double client_speed, double capacity)
        : client_speed_(client_speed), capacity_(capacity) {}

    void start(double now, double amount, const Answer& answer) {
        advance(now);
        jobs_.push({served_ + amount, ++number_, answer});
        total_ += amount;
        slowest_speed_ = std::min(slowest_speed_, speed());
    }

    /// The time of the next answer if nothing starts before it; kNever without jobs.
    [[nodiscard]] double next() const {
        return jobs_.empty() ? kNever : now_ + std::max(0.0, jobs_.top().end - served_) / speed();
    }

    /// Ends the job whose time next() is.
    Answer finish() {
        advance(next());
        const Answer answer = jobs_.top().answer;
        jobs_.pop();
        return answer;
    }

    [[nodiscard]] double total() const { return total_; }
    [[nodiscard]] double peak() const { return load_.peak(); }
    [[nodiscard]] double slowest_speed() const { return slowest_speed_; }

  private:
    struct Job {
        double end = 0;  // as an amount that each client has been served since the beginning
        std::size_t number = 0;
        Answer answer;

        bool operator>(const Job& other) const {
            return std::pair(end, number) > std::pair(other.end, other.number);
        }
    };

    [[nodiscard]] double speed() const {
        const double part = capacity_ / static_cast<double>(std::max<std::size_t>(1, jobs_.size()));
        return capacity_ > 0 ? std::min(client_speed_, part) : client_speed_;
    }

    void advance(double now) {
        if (!jobs_.empty() && now > now_) {
            const double amount = speed() * (now - now_);
            served_ += amount;
            load_.add(now_, now, amount * static_cast<double>(jobs_.size()));
        }
        now_ = std::max(now_, now);
    }

    double client_speed_;
    double capacity_;
    std::priority_queue<Job, std::vector<Job>, std::greater<>> jobs_;
    PeakPerSecond load_;
    double now_ = 0;
    double served_ = 0;
    double total_ = 0;
    double slowest_speed_ = kNever;
    std::size_t number_ = 0;
};

}  // namespace carom::bench
