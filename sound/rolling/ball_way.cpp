#include "sound/rolling/ball_way.h"

#include <algorithm>
#include <cmath>

#include "sim/timeline/hermite.h"
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

void add_interval(const KeyInterval& interval, double from, double to, double longest_piece,
                  BallWays& ways) {
    const auto count = static_cast<int>(std::ceil((to - from) / longest_piece));
    const double duration = (to - from) / count;
    BallSpeeds start = interval.at(from);
    for (int i = 0; i < count; ++i) {
        const double time = from + i * duration;
        const double next = i + 1 == count ? to : from + (i + 1) * duration;
        if (!(next > time)) {
            continue;
        }
        const BallSpeeds middle = interval.at(time + (next - time) / 2);
        const BallSpeeds end = interval.at(next);
        ways.rolled.add(time, next - time, {start.rolled, middle.rolled, end.rolled},
                        {rolling_pressure(start.rolled), rolling_pressure(end.rolled)});
        ways.slid.add(time, next - time, {start.slid, middle.slid, end.slid},
                      {sliding_pressure(start.slid), sliding_pressure(end.slid)});
        start = end;
    }
}

}  // namespace

BallSpeeds ball_speeds(const Vec3& velocity, const Vec3& angular_velocity, double radius) {
    // w x (0, 0, -r) = (-w_y r, w_x r, 0)
    const double slip_x = velocity.x - angular_velocity.y * radius;
    const double slip_y = velocity.y + angular_velocity.x * radius;
    return {std::sqrt(velocity.x * velocity.x + velocity.y * velocity.y),
            std::sqrt(slip_x * slip_x + slip_y * slip_y)};
}

BallWays ball_ways(const sim::Track& track, double radius, double from, double to) {
    BallWays ways;
    const std::span<const sim::Key> keys = track.keys();
    const double longest_piece = std::max(kLongestPiece, (to - from) / kMostPieces);
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
        if (!track.jumps_after(index - 1)) {
            const double first = std::max(from, start.time);
            const double last = std::min(to, end.time);
            if (first < last) {
                add_interval({start, end, radius}, first, last, longest_piece, ways);
            }
        }
    }
    return ways;
}

}  // namespace carom::sound
