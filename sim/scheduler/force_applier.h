// Applies the actions of force events to bodies.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "sim/scheduler/ball_placer.h"
#include "sim/scheduler/bodies.h"
#include "sim/scheduler/force_schedule.h"
#include "sim/scheduler/touching_balls.h"
#include "sim/stick/strike.h"

namespace carom::sim {

class ForceApplier {
  public:
    ForceApplier(const WorldDescription& world, const StaticEnvironment& environment,
                 Bodies& bodies, Recorder& recorder, BallPlacer& placer);

    void apply(const DueAction& action);

    /// One warning for each strike whose ball never hit its target.
    [[nodiscard]] std::vector<Diagnostic> missed_strikes() const;

  private:
    void apply(const Force& force, const DueAction& due, std::uint32_t body);
    void apply(const Torque& torque, const DueAction& due, std::uint32_t body);
    void apply(const Impulse& impulse, const DueAction& due, std::uint32_t body);
    void apply(const SetVelocity& velocity, const DueAction& due, std::uint32_t body);
    void apply(const Strike& strike, const DueAction& due, std::uint32_t body);
    void apply(const PlaceBall& place, const DueAction& due, std::uint32_t body);
    void apply(const RemoveBall& remove, const DueAction& due, std::uint32_t body);
    void strike_free(const StrikeResult& result, double time, std::uint32_t body);
    void warn_of_unreached(const Strike& strike, const DueAction& due, const std::string& ball);
    void strike_group(const Strike& strike, const Vec3& aim, double time, TouchingBalls touching);
    void apply_impulse_step(const DueAction& due, std::uint32_t body);
    void apply_impulse(std::uint32_t body, double time, const Vec3& impulse,
                       const Vec3& angular_impulse);
    [[nodiscard]] Quat orientation_of(std::uint32_t body, double time) const;
    [[nodiscard]] Vec3 aim_direction(const Strike& strike, const Vec3& from, double time) const;
    [[nodiscard]] Vec3 position_of(const std::string& name, double time) const;

    struct AimedStrike {
        std::string ball, target;
        double time = 0;
        std::size_t event = 0;
    };

    const WorldDescription& world_;
    const StaticEnvironment& environment_;
    Bodies& bodies_;
    Recorder& recorder_;
    BallPlacer& placer_;
    std::map<std::string, std::uint32_t> index_by_name_;  // indices in Bodies
    std::vector<AimedStrike> aimed_strikes_;
};

}  // namespace carom::sim
