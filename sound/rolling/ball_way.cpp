#include "sound/rolling/ball_way.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "sim/timeline/hermite.h"
#include "sound/level/decibels.h"
#include "sound/rolling/rolling_level.h"

namespace carom::sound {
namespace {

constexpr double kLongestPiece = 0.010;  // s
constexpr double kMostPieces = 65536;

/// The motion from one key to the next.
class KeyInterval {
  public:
    KeyInterval(const sim::Key& from, const sim::Key& to, double radius)
        : segment_{from.time,   to.time,           from.position,
                   to.position, from.velocity_out, to.velocity_in},
          spin_(from.angular_velocity_out),
          spin_change_(to.angular_velocity_in - from.angular_velocity_out),
          radius_(radius) {}

    [[nodiscard]] double start() const { return segment_.start; }
    [[nodiscard]] double end() const { return segment_.end; }

    [[nodiscard]] BallSpeeds at(double time) const {
        const double part = (time - segment_.start) / (segment_.end - segment_.start);
        return ball_speeds(sim::hermite_velocity(segment_, time), spin_ + spin_change_ * part,
                           radius_);
    }

  private:
    sim::PathSegment segment_;
    Vec3 spin_, spin_change_;
    double radius_;
};

/// A change of the speeds at once, which is heard over a contact.
struct Jump {
    double time = 0;
    double duration = 0;
    BallSpeeds change;  // what was before it, less what is after it

    [[nodiscard]] double end() const { return time + duration; }

    /// The part of the change that is still to come, by the smooth step.
    [[nodiscard]] double left_at(double now) const {
        const double x = std::clamp((now - time) / duration, 0.0, 1.0);
        return 1 - x * x * (3 - 2 * x);
    }
};

double duration_at(double time, std::span<const Touch> touches) {
    constexpr double kUnknown = 1e-3;  // s
    constexpr double kSame = 1e-9;     // s
    auto touch = std::partition_point(touches.begin(), touches.end(),
                                      [&](const Touch& t) { return t.time < time - kSame; });
    double longest = 0;
    for (; touch != touches.end() && touch->time <= time + kSame; ++touch) {
        longest = std::max(longest, touch->duration);
    }
    return longest > 0 ? longest : kUnknown;
}

/// Adds one interval between keys after the other.
class WayMaker {
  public:
    WayMaker(double radius, double longest_piece) : radius_(radius), longest_(longest_piece) {}

    void jump(const sim::Key& key, double duration) {
        const BallSpeeds before = ball_speeds(key.velocity_in, key.angular_velocity_in, radius_);
        const BallSpeeds after = ball_speeds(key.velocity_out, key.angular_velocity_out, radius_);
        jumps_.push_back(
            {key.time, duration, {before.rolled - after.rolled, before.slid - after.slid}});
    }

    void add(const KeyInterval& interval, double from, double to) {
        std::vector<double> cuts;
        for (const Jump& jump : jumps_) {
            if (from < jump.end() && jump.end() < to) {
                cuts.push_back(jump.end());
            }
        }
        std::ranges::sort(cuts);
        cuts.push_back(to);
        for (const double cut : cuts) {
            add_pieces(interval, from, cut);
            from = cut;
        }
        std::erase_if(jumps_, [&](const Jump& jump) { return jump.end() <= to; });
    }

    BallWays ways;

  private:
    [[nodiscard]] BallSpeeds at(const KeyInterval& interval, double time) const {
        BallSpeeds speeds = interval.at(time);
        for (const Jump& jump : jumps_) {
            const double left = jump.left_at(time);
            speeds.rolled += left * jump.change.rolled;
            speeds.slid += left * jump.change.slid;
        }
        return {std::max(speeds.rolled, 0.0), std::max(speeds.slid, 0.0)};
    }

    /// No contact ends between `from` and `to`.
    void add_pieces(const KeyInterval& interval, double from, double to) {
        double longest = longest_;
        for (const Jump& jump : jumps_) {
            longest = from < jump.end() ? std::min(longest, jump.duration / 4) : longest;
        }
        const auto count = static_cast<int>(std::ceil((to - from) / longest));
        const double duration = (to - from) / count;
        BallSpeeds start = at(interval, from);
        for (int i = 0; i < count; ++i) {
            const double time = from + i * duration;
            const double next = i + 1 == count ? to : from + (i + 1) * duration;
            if (!(next > time)) {
                continue;
            }
            const BallSpeeds middle = at(interval, time + (next - time) / 2);
            const BallSpeeds end = at(interval, next);
            ways.rolled.add(time, next - time, {start.rolled, middle.rolled, end.rolled},
                            {rolling_pressure(start.rolled), rolling_pressure(end.rolled)});
            ways.slid.add(time, next - time, {start.slid, middle.slid, end.slid},
                          {sliding_pressure(start.slid), sliding_pressure(end.slid)});
            start = end;
        }
    }

    double radius_;
    double longest_;  // of the pieces, s
    std::vector<Jump> jumps_;
};

}  // namespace

BallSpeeds ball_speeds(const Vec3& velocity, const Vec3& angular_velocity, double radius) {
    // w x (0, 0, -r) = (-w_y r, w_x r, 0)
    const double slip_x = velocity.x - angular_velocity.y * radius;
    const double slip_y = velocity.y + angular_velocity.x * radius;
    return {std::sqrt(velocity.x * velocity.x + velocity.y * velocity.y),
            std::sqrt(slip_x * slip_x + slip_y * slip_y)};
}

BallWays ball_ways(const sim::Track& track, double radius, double from, double to,
                   std::span<const Touch> touches) {
    const std::span<const sim::Key> keys = track.keys();
    WayMaker maker(radius, std::max(kLongestPiece, (to - from) / kMostPieces));
    const auto after =
        std::upper_bound(keys.begin(), keys.end(), from,
                         [](double time, const sim::Key& key) { return time < key.time; });
    auto index = static_cast<std::size_t>(after - keys.begin());
    for (index = std::max<std::size_t>(index, 1); index < keys.size(); ++index) {
        const sim::Key& start = keys[index - 1];
        const sim::Key& end = keys[index];
        if (start.time >= to) {
            break;
        }
        if (start.is_break()) {
            maker.jump(start, duration_at(start.time, touches));
        }
        if (!track.jumps_after(index - 1)) {
            const double first = std::max(from, start.time);
            const double last = std::min(to, end.time);
            if (first < last) {
                maker.add({start, end, radius}, first, last);
            }
        }
    }
    return std::move(maker.ways);
}

void apply_dynamics(double ratio, BallWays& ways) {
    for (std::size_t i = 0; i < std::max(ways.rolled.size(), ways.slid.size()); ++i) {
        for (std::size_t end = 0; end < 2; ++end) {
            double square = 0;
            const auto for_both = [&](const auto& change) {
                for (Way* way : {&ways.rolled, &ways.slid}) {
                    if (i < way->size()) {
                        change(way->ends(i).pressures[end]);
                    }
                }
            };
            for_both([&](double pressure) { square += pressure * pressure; });
            const double factor = dynamics_factor(std::sqrt(square), ratio, kQuietRush);
            for_both([&](double& pressure) { pressure *= factor; });
        }
    }
}

}  // namespace carom::sound
