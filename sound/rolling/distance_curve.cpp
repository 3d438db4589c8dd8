#include "sound/rolling/distance_curve.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/assert.h"
#include "core/elementary.h"
#include "sim/timeline/hermite.h"
#include "sound/level/decibels.h"

namespace carom::sound {
namespace {

constexpr double kLongestPiece = 0.010;  // s
constexpr double kMaxPieces = 65536;

constexpr double kAtOneMetrePerSecond = 2e-3;     // Pa, 40 dB
constexpr double kRollingExponent = 1.494867641;  // 9 dB / (20 dB log10(2))
constexpr double kSlidingFactor = 1.4125375446;   // 3 dB
constexpr double kScraping = 3.5565588201e-3;     // Pa, 45 dB

/// 0 up to `least`, 1 from twice that speed on.
double fade_in(double speed, double least) {
    return std::clamp(speed / least - 1, 0.0, 1.0);
}

/// The speeds of both curves of a ball.
struct BallSpeeds {
    double rolled = 0;  // m/s
    double slid = 0;
};

BallSpeeds ball_speeds(const Vec3& velocity, const Vec3& angular_velocity, double radius) {
    // w x (0, 0, -r) = (-w_y r, w_x r, 0)
    const double slip_x = velocity.x - angular_velocity.y * radius;
    const double slip_y = velocity.y + angular_velocity.x * radius;
    return {std::sqrt(velocity.x * velocity.x + velocity.y * velocity.y),
            std::sqrt(slip_x * slip_x + slip_y * slip_y)};
}

/// The motion from one key to the next.
class KeyInterval {
  public:
    KeyInterval(const sim::Key& from, const sim::Key& to, double radius)
        : segment_{from.time,   to.time,           from.position,
                   to.position, from.velocity_out, to.velocity_in},
          spin_(from.angular_velocity_out),
          spin_change_(to.angular_velocity_in - from.angular_velocity_out),
          radius_(radius) {}

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
struct SpeedStep {
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

double duration_at(double time, std::span<const ContactTime> contacts) {
    constexpr double kUnknown = 1e-3;  // s
    constexpr double kSame = 1e-9;     // s
    auto contact =
        std::partition_point(contacts.begin(), contacts.end(),
                             [&](const ContactTime& c) { return c.time < time - kSame; });
    double longest = 0;
    for (; contact != contacts.end() && contact->time <= time + kSame; ++contact) {
        longest = std::max(longest, contact->duration);
    }
    return longest > 0 ? longest : kUnknown;
}

/// Adds one interval between keys after the other.
class CurveMaker {
  public:
    CurveMaker(double radius, double longest_piece) : radius_(radius), longest_(longest_piece) {}

    void step(const sim::Key& key, double duration) {
        const BallSpeeds before = ball_speeds(key.velocity_in, key.angular_velocity_in, radius_);
        const BallSpeeds after = ball_speeds(key.velocity_out, key.angular_velocity_out, radius_);
        steps_.push_back(
            {key.time, duration, {before.rolled - after.rolled, before.slid - after.slid}});
    }

    void add(const KeyInterval& interval, double from, double to) {
        std::vector<double> cuts;
        for (const SpeedStep& step : steps_) {
            if (from < step.end() && step.end() < to) {
                cuts.push_back(step.end());
            }
        }
        std::ranges::sort(cuts);
        cuts.push_back(to);
        for (const double cut : cuts) {
            add_pieces(interval, from, cut);
            from = cut;
        }
        std::erase_if(steps_, [&](const SpeedStep& step) { return step.end() <= to; });
    }

    BallCurves curves;

  private:
    [[nodiscard]] BallSpeeds at(const KeyInterval& interval, double time) const {
        BallSpeeds speeds = interval.at(time);
        for (const SpeedStep& step : steps_) {
            const double left = step.left_at(time);
            speeds.rolled += left * step.change.rolled;
            speeds.slid += left * step.change.slid;
        }
        return {std::max(speeds.rolled, 0.0), std::max(speeds.slid, 0.0)};
    }

    /// No contact ends between `from` and `to`.
    void add_pieces(const KeyInterval& interval, double from, double to) {
        double longest = longest_;
        for (const SpeedStep& step : steps_) {
            longest = from < step.end() ? std::min(longest, step.duration / 4) : longest;
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
            curves.rolled.add(time, next - time, {start.rolled, middle.rolled, end.rolled},
                              {rolling_pressure(start.rolled), rolling_pressure(end.rolled)});
            curves.slid.add(time, next - time, {start.slid, middle.slid, end.slid},
                            {sliding_pressure(start.slid), sliding_pressure(end.slid)});
            start = end;
        }
    }

    double radius_;
    double longest_;  // of the pieces, s
    std::vector<SpeedStep> steps_;
};

/// Adds a piece from the slip and force of one scrape to those of another.
void add_scraping(double from, double to, const Scrape& first, const Scrape& last,
                  DistanceCurve& curve) {
    if (to > from) {
        curve.add(
            from, to - from, {first.slip, (first.slip + last.slip) / 2, last.slip},
            {scraping_pressure(first.slip, first.force), scraping_pressure(last.slip, last.force)});
    }
}

}  // namespace

void DistanceCurve::add(double time, double duration, const std::array<double, 3>& speeds,
                        const std::array<double, 2>& pressures) {
    CAROM_ASSERT(duration > 0);
    CAROM_ASSERT(pieces_.empty() || time >= pieces_.back().time);
    const double distance = duration * (speeds[0] + 4 * speeds[1] + speeds[2]) / 6;
    const double at_start = speeds[0] * duration;
    const double at_end = speeds[2] * duration;
    pieces_.push_back(
        {time,
         duration,
         length_,
         {at_start, 3 * distance - 2 * at_start - at_end, at_start + at_end - 2 * distance},
         {{speeds[0], speeds[2]}, pressures}});
    length_ += distance;
}

CurvePoint DistanceCurve::at(double time) {
    if (pieces_.empty() || time < pieces_.front().time) {
        return {};
    }
    const auto is_in = [&](std::size_t index) {
        return pieces_[index].time <= time &&
               (index + 1 == pieces_.size() || time < pieces_[index + 1].time);
    };
    if (!is_in(last_)) {
        if (last_ + 1 < pieces_.size() && is_in(last_ + 1)) {
            ++last_;
        } else if (last_ > 0 && is_in(last_ - 1)) {
            --last_;
        } else {
            const auto after = std::ranges::upper_bound(pieces_, time, {}, &Piece::time);
            last_ = static_cast<std::size_t>(after - pieces_.begin()) - 1;
        }
    }
    const Piece& piece = pieces_[last_];
    const std::array<double, 3>& c = piece.curve;
    const double s = (time - piece.time) / piece.duration;
    if (s > 1) {
        return {piece.distance + c[0] + c[1] + c[2], last_, 1, true};
    }
    return {piece.distance + s * (c[0] + s * (c[1] + s * c[2])), last_, s, false};
}

double rolling_pressure(double speed) {
    const double fade = fade_in(speed, 0.020);
    return fade > 0 ? fade * kAtOneMetrePerSecond * power(speed, kRollingExponent) : 0;
}

double sliding_pressure(double slip) {
    return kSlidingFactor * rolling_pressure(slip);
}

double scraping_pressure(double slip, double force) {
    const double fade = fade_in(slip, 0.002);
    if (!(fade > 0 && force > 0)) {
        return 0;
    }
    return fade * kScraping * power(slip / 0.1, 0.75) * std::sqrt(force);
}

BallCurves ball_curves(const sim::Track& track, double radius, double from, double to,
                       std::span<const ContactTime> contacts) {
    const std::span<const sim::Key> keys = track.keys();
    CurveMaker maker(radius, std::max(kLongestPiece, (to - from) / kMaxPieces));
    const auto after = std::ranges::upper_bound(keys, from, {}, &sim::Key::time);
    auto index = static_cast<std::size_t>(after - keys.begin());
    for (index = std::max<std::size_t>(index, 1); index < keys.size(); ++index) {
        const sim::Key& start = keys[index - 1];
        const sim::Key& end = keys[index];
        if (start.time >= to) {
            break;
        }
        if (start.is_break()) {
            maker.step(start, duration_at(start.time, contacts));
        }
        if (!track.jumps_after(index - 1)) {
            const double first = std::max(from, start.time);
            const double last = std::min(to, end.time);
            if (first < last) {
                maker.add({start, end, radius}, first, last);
            }
        }
    }
    return std::move(maker.curves);
}

void apply_dynamics(double ratio, BallCurves& curves) {
    for (std::size_t i = 0; i < std::max(curves.rolled.size(), curves.slid.size()); ++i) {
        for (std::size_t end = 0; end < 2; ++end) {
            double square = 0;
            const auto for_both = [&](const auto& change) {
                for (DistanceCurve* curve : {&curves.rolled, &curves.slid}) {
                    if (i < curve->size()) {
                        change(curve->ends(i).pressures[end]);
                    }
                }
            };
            for_both([&](double pressure) { square += pressure * pressure; });
            const double factor = compressor_gain(std::sqrt(square), ratio, kQuietNoise);
            for_both([&](double& pressure) { pressure *= factor; });
        }
    }
}

DistanceCurve scraping_curve(std::span<const Scrape> scrapes) {
    const auto middle_of = [](const Scrape& scrape) {
        return scrape.from + (scrape.to - scrape.from) / 2;
    };
    DistanceCurve curve;
    if (scrapes.empty()) {
        return curve;
    }
    const Scrape& first = scrapes.front();
    const Scrape& last = scrapes.back();
    add_scraping(first.from, middle_of(first), first, first, curve);
    for (std::size_t i = 1; i < scrapes.size(); ++i) {
        add_scraping(middle_of(scrapes[i - 1]), middle_of(scrapes[i]), scrapes[i - 1], scrapes[i],
                     curve);
    }
    add_scraping(middle_of(last), last.to, last, last, curve);
    return curve;
}

}  // namespace carom::sound
