// The ball return of a table: which ball leaves a pocket that is full.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/scheduler/moving_body.h"
#include "sim/scheduler/static_environment.h"

namespace carom::sim {

/// A pocket keeps the last balls that fell in, as many as lie well below the cloth. Where another
/// one falls in, the earliest of them leaves through the pocket's floor. `bodies` must outlive
/// this.
class BallReturn {
  public:
    BallReturn(const StaticEnvironment& environment, const std::vector<MovingBody>& bodies);

    /// The centre of the ball has sunk below the cloth in that pocket, for the first time.
    void note_potted(std::uint32_t ball, std::size_t pocket, double time);
    /// A ball has come to rest in the mouth of that pocket without being potted: if it lies on
    /// balls that are, they make room.
    void note_blocked(std::uint32_t ball, std::size_t pocket, double time);

    /// The ball is put somewhere else: it lies in no pocket.
    void forget(std::uint32_t ball);

    [[nodiscard]] bool is_due() const { return !due_.empty(); }
    /// The balls that leave now, and the height (m) of the centre at which each one stops.
    struct Leaving {
        std::uint32_t ball = 0;
        double stops_at = 0;
    };
    [[nodiscard]] std::vector<Leaving> take_due();

    /// Number of balls that lie in a pocket of this radius and depth (m) so that another one,
    /// lying on them, would still have its centre well below the cloth.
    [[nodiscard]] static std::size_t capacity(double pocket_radius, double drop,
                                              double ball_radius);

  private:
    [[nodiscard]] std::vector<std::uint32_t> balls_in(std::size_t pocket, double time) const;
    void let_go(std::uint32_t ball, std::size_t pocket);

    const StaticEnvironment& environment_;
    const std::vector<MovingBody>& bodies_;
    std::vector<std::size_t> capacity_;               // per pocket; empty without a ball return
    std::vector<std::vector<std::uint32_t>> potted_;  // per pocket, the earliest first
    std::vector<Leaving> due_;
};

}  // namespace carom::sim
