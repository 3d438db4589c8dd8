// What force events do to bodies.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "sim/scheduler/balls.h"
#include "sim/scheduler/force_schedule.h"
#include "sim/scheduler/stepped_bodies.h"

namespace carom::sim {

class Actions {
  public:
    Actions(const WorldDescription& world, Balls& balls, SteppedBodies& stepped,
            Recording& recording);

    void apply(const DueAction& action);

    /// A warning of each strike that never reached what it was aimed at.
    [[nodiscard]] std::vector<Diagnostic> missed_strikes() const;

  private:
    void begin(const Force& force, const DueAction& due, std::uint32_t body);
    void begin(const Torque& torque, const DueAction& due, std::uint32_t body);
    void begin(const Impulse& impulse, const DueAction& due, std::uint32_t body);
    void begin(const SetVelocity& velocity, const DueAction& due, std::uint32_t body);
    void begin(const Strike& strike, const DueAction& due, std::uint32_t body);
    void kick(const DueAction& due, std::uint32_t body);
    void push(std::uint32_t body, double time, const Vec3& impulse, const Vec3& angular_impulse);
    void change(std::uint32_t body, double time, const MotionState& before,
                const MotionState& after);
    [[nodiscard]] MotionState state_of(std::uint32_t body, double time) const;
    [[nodiscard]] Quat axes_of(std::uint32_t body, double time) const;
    [[nodiscard]] const std::string& name_of(std::uint32_t body) const;
    [[nodiscard]] Vec3 aim_of(const Strike& strike, const Vec3& from, double time) const;
    [[nodiscard]] Vec3 place_of(const std::string& name, double time) const;

    struct Aimed {
        std::string ball, target;
        double time = 0;
        std::size_t event = 0;
    };

    const WorldDescription& world_;
    Balls& balls_;
    SteppedBodies& stepped_;
    Recording& recording_;
    std::map<std::string, std::uint32_t> index_;  // numbers in SteppedBodies
    std::vector<Aimed> aimed_;
};

}  // namespace carom::sim
