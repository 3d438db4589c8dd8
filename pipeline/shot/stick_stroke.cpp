#include "pipeline/shot/stick_stroke.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Imath/ImathMatrixAlgo.h>

#include "pipeline/shot/keyed_motion.h"

namespace carom::pipeline {

namespace {

constexpr double kInstant = 1e-5;    // s, in which the contact changes the stick's speed
constexpr double kWarmUpPart = 0.6;  // of the back-swing
constexpr Vec3 kUp{0, 0, 1};
constexpr double kLift = 0.3;   // m, by which a withdrawn stick is above its line
constexpr double kBack = 0.35;  // m, by which it is behind the ball then
constexpr double kAway = 8;     // m, out of sight

double back_swing(const StickStrike& strike) {
    return std::clamp(0.06 + 0.045 * strike.speed, 0.08, 0.3);
}

/// A stroke of constant acceleration.
double stroke_time(const StickStrike& strike) {
    return 2 * back_swing(strike) / strike.speed;
}

/// The z axis of the stick points against its direction, its x axis to the player's right.
Quat orientation_of(const StickStrike& strike) {
    const Vec3& d = strike.direction;
    const Vec3 side = d.cross(kUp);
    const Vec3 right = side.length() > 1e-9 ? side.normalized() : Vec3(0, -1, 0);
    const Vec3 up = right.cross(d);
    const Imath::M44d rows(right.x, right.y, right.z, 0, up.x, up.y, up.z, 0, -d.x, -d.y, -d.z, 0,
                           0, 0, 0, 1);
    return Imath::extractQuat(rows).normalized();
}

class StrokePath {
  public:
    explicit StrokePath(const StrokeHabit& habit) : habit_(habit) {}

    /// Adds everything from the address, or the approach to it, to the withdrawal.
    void add(const StickStrike& strike, double start) {
        orientation_ = orientation_of(strike);
        strike_ = &strike;
        const double swing = back_swing(strike);
        const double begin_stroke = strike.time - stroke_time(strike);
        const double end_back = begin_stroke - habit_.back_pause;
        const double begin_back = end_back - habit_.back_swing_time;
        const double address = begin_back - habit_.address_pause;
        const double free_time = address - earliest(start);
        const int warm_ups = std::clamp(
            static_cast<int>(std::floor(free_time / habit_.warm_up_time)), 0, habit_.most_warm_ups);
        double time = address - warm_ups * habit_.warm_up_time;
        approach(time);
        for (int i = 0; i < warm_ups; ++i) {
            key(time + 0.5 * habit_.warm_up_time, -habit_.gap - kWarmUpPart * swing, 0);
            time += habit_.warm_up_time;
            key(time, -habit_.gap, 0);
        }
        key(begin_back, -habit_.gap, 0);
        key(end_back, -swing, 0);
        key(begin_stroke, -swing, 0);
        key(strike.time, 0, strike.speed);
        key(strike.time + kInstant, 0, strike.speed_after);
        follow(strike);
    }

    /// The stick is carried out of sight after the last strike.
    void leave() { carry_away(keys_.back().time + habit_.leaving_time); }

    [[nodiscard]] KeyedMotion take() { return {std::move(keys_), false}; }

  private:
    /// The time from which the stick may be at the next ball.
    [[nodiscard]] double earliest(double start) const {
        return keys_.empty() ? start : keys_.back().time + habit_.withdrawal_time;
    }

    /// Adds a state on the stick's line; earlier than the last key, it is left out.
    void key(double time, double along, double speed) {
        if (!keys_.empty() && time <= keys_.back().time) {
            return;
        }
        MotionKey next;
        next.time = time;
        next.position = strike_->contact + strike_->direction * along;
        next.rotate = orientation_;
        next.velocity = strike_->direction * speed;
        keys_.push_back(next);
    }

    void place(double time, const Vec3& position) {
        if (time <= keys_.back().time) {
            return;
        }
        MotionKey next;
        next.time = time;
        next.position = position;
        next.rotate = orientation_;
        next.velocity = Vec3(0, 0, 0);
        keys_.push_back(next);
    }

    /// Brings the stick from where it was withdrawn to the address at `time`.
    void approach(double time) {
        if (!keys_.empty()) {
            const double above = time - 0.5 * habit_.withdrawal_time;
            const Quat before = *keys_.back().rotate;
            if (above - keys_.back().time > 2 * habit_.leaving_time) {
                const Quat next = std::exchange(orientation_, before);
                carry_away(keys_.back().time + habit_.leaving_time);
                orientation_ = next;
                place(above - habit_.leaving_time, away());
            }
            place(above, withdrawn());
        }
        key(time, -habit_.gap, 0);
    }

    /// The follow-through has a constant deceleration; then the stick goes back and up.
    void follow(const StickStrike& strike) {
        const double way = std::min(std::clamp(0.04 + 0.02 * strike.speed_after, 0.04, 0.15),
                                    strike.follow_through);
        double time = strike.time + kInstant;
        if (way > 1e-4) {
            time += 2 * way / strike.speed_after;
            key(time, way, 0);
        }
        key(time + 0.25, way, 0);
        place(time + 0.25 + habit_.withdrawal_time, withdrawn());
    }

    void carry_away(double time) { place(time, away()); }

    [[nodiscard]] Vec3 withdrawn() const {
        return strike_->contact - strike_->direction * kBack + kUp * kLift;
    }
    [[nodiscard]] Vec3 away() const {
        const Vec3 level(strike_->direction.x, strike_->direction.y, 0);
        const Vec3 back = level.length() > 1e-9 ? level.normalized() : Vec3(1, 0, 0);
        return strike_->contact - back * kAway + kUp;
    }

    const StrokeHabit& habit_;
    const StickStrike* strike_ = nullptr;
    Quat orientation_;
    std::vector<MotionKey> keys_;
};

}  // namespace

double shortest_stroke(const StickStrike& strike, const StrokeHabit& habit) {
    return stroke_time(strike) + habit.back_pause + habit.back_swing_time;
}

sim::Track stick_track(std::string name, const std::vector<StickStrike>& strikes, double start,
                       const StrokeHabit& habit) {
    StrokePath path(habit);
    for (const StickStrike& strike : strikes) {
        path.add(strike, start);
    }
    path.leave();
    return keyed_track(std::move(name), path.take());
}

}  // namespace carom::pipeline
