#include "pipeline/export/linear_keys.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "core/error.h"
#include "sim/timeline/rotation.h"

namespace carom::pipeline {

namespace {

constexpr int kMaxDepth = 16;  // of the bisection of an interval

class KeyInserter {
  public:
    KeyInserter(const sim::Track& track, std::size_t most, const LinearTolerance& tolerance)
        : track_(track), most_(most), tolerance_(tolerance) {}

    LinearKeys run() {
        const auto keys = track_.keys();
        jump_ = track_.jumps_after(0) ? &keys.front() : nullptr;
        add(keys.front().time);
        for (std::size_t i = 1; i < keys.size(); ++i) {
            jump_ = track_.jumps_after(i) ? &keys[i] : nullptr;
            if (track_.jumps_after(i - 1)) {
                result_.jumps.push_back(result_.size());
                add(keys[i].time);
            } else {
                add_interval(keys[i - 1], keys[i]);
            }
        }
        return std::move(result_);
    }

  private:
    [[noreturn]] void refuse() const {
        throw Error(fmt::format(
            "the motion of '{}' needs more than {} keys; export a shorter shot, or a .csv",
            track_.name(), most_));
    }

    void add(double time) {
        if (result_.size() >= most_) {
            refuse();
        }
        const MotionState state = state_at(time);
        result_.add(time, state.position, state.orientation);
    }

    /// At the end of an interval that a jump follows: the state before the jump.
    [[nodiscard]] MotionState state_at(double time) const {
        if (jump_ != nullptr && time == jump_->time) {
            return {jump_->position, jump_->orientation, Vec3(0), Vec3(0)};
        }
        return track_.sample(time);
    }

    /// Divides the interval so that no part turns by more than the tolerance. The angular velocity
    /// is linear in time, so its maximum is at one of the ends.
    void add_interval(const sim::Key& from, const sim::Key& to) {
        const double duration = to.time - from.time;
        const double fastest =
            std::max(from.angular_velocity_out.length(), to.angular_velocity_in.length());
        const double wanted = std::max(1.0, std::ceil(fastest * duration / tolerance_.turn));
        if (wanted > static_cast<double>(most_)) {
            refuse();
        }
        const auto parts = static_cast<std::size_t>(wanted);
        double last = from.time;
        for (std::size_t part = 1; part <= parts; ++part) {
            const double fraction = static_cast<double>(part) / static_cast<double>(parts);
            const double next = part == parts ? to.time : from.time + duration * fraction;
            refine(last, next, 0);
            last = next;
        }
    }

    /// Adds the end of (from, to] and the keys that are needed in between. The key at `from` exists
    /// already.
    void refine(double from, double to, int depth) {
        const double middle = from + (to - from) / 2;
        const bool can_be_halved = depth < kMaxDepth && middle > from && middle < to;
        if (can_be_halved && !is_straight(from, to)) {
            refine(from, middle, depth + 1);
            refine(middle, to, depth + 1);
            return;
        }
        add(to);
    }

    [[nodiscard]] bool is_straight(double from, double to) const {
        const MotionState start = track_.sample(from);
        const MotionState end = state_at(to);
        return std::ranges::all_of(std::initializer_list<double>{0.25, 0.5, 0.75}, [&](double s) {
            const MotionState there = track_.sample(from + s * (to - from));
            const Vec3 position = start.position + s * (end.position - start.position);
            const Quat turned =
                Imath::slerpShortestArc(start.orientation, end.orientation, s).normalized();
            return (there.position - position).length() <= tolerance_.position &&
                   sim::angle_between(there.orientation, turned) <= tolerance_.orientation;
        });
    }

    const sim::Track& track_;
    std::size_t most_;
    LinearTolerance tolerance_;
    const sim::Key* jump_ = nullptr;  // the key at which the present interval ends before a jump
    LinearKeys result_;
};

}  // namespace

bool LinearKeys::is_constant() const {
    for (std::size_t i = 1; i < size(); ++i) {
        if (positions[i] != positions[0] || orientations[i] != orientations[0]) {
            return false;
        }
    }
    return true;
}

void LinearKeys::add(double time, const Vec3& position, Quat orientation) {
    if (size() > 0 && (orientation ^ orientations.back()) < 0) {
        orientation = Quat(-orientation.r, -orientation.v);
    }
    times.push_back(time);
    positions.push_back(position);
    orientations.push_back(orientation);
}

LinearKeys LinearKeys::from(double time) const {
    const auto first =
        static_cast<std::size_t>(std::ranges::lower_bound(times, time) - times.begin());
    LinearKeys rest;
    if (first == size() || (first > 0 && times[first] > time)) {
        const std::size_t before = first - 1;
        if (first == size() || jumps_to(first)) {
            rest.add(time, positions[before], orientations[before]);
        } else {
            const double s = (time - times[before]) / (times[first] - times[before]);
            rest.add(
                time, positions[before] + s * (positions[first] - positions[before]),
                Imath::slerpShortestArc(orientations[before], orientations[first], s).normalized());
        }
    }
    for (std::size_t i = first; i < size(); ++i) {
        if (rest.size() > 0 && jumps_to(i)) {
            rest.jumps.push_back(rest.size());
        }
        rest.add(times[i], positions[i], orientations[i]);
    }
    return rest;
}

LinearKeys linear_keys(const sim::Track& track, std::size_t most,
                       const LinearTolerance& tolerance) {
    return KeyInserter(track, most, tolerance).run();
}

}  // namespace carom::pipeline
