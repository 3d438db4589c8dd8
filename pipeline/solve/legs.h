// The straight pieces of a ball's way between what it meets, by the log of events alone.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/vectors.h"
#include "sim/timeline/event.h"
#include "sim/world.h"

namespace carom::pipeline::solve {

/// From one impact of a ball to its next one, its pocket or its end, seen from above.
struct Leg {
    /// Of all that led to it, in order: strikes, impacts of balls and of cushions, each with its
    /// side. Equal for two strikes whose balls came here the same way.
    std::uint64_t cause = 0;
    Vec2 from{0, 0};       // of the ball's centre
    Vec2 direction{1, 0};  // unit
    double length = 0;     // m

    [[nodiscard]] Vec2 end() const { return from + direction * length; }
    /// The distance (m) by which the leg passes to the right of a point, negative to the left; NaN
    /// if the point is behind its start.
    [[nodiscard]] double miss(const Vec2& point) const;
};

/// The leg with that cause; null if there is none.
[[nodiscard]] const Leg* leg_with(const std::vector<Leg>& legs, std::uint64_t cause);

/// The balls' radii by their names.
using Radii = std::map<std::string, double>;
[[nodiscard]] Radii radii_of(const sim::WorldDescription& world);

/// The centre (m) of the ball `name` of `radius` in an event in which it takes part.
[[nodiscard]] Vec2 centre_in(const sim::Event& event, const std::string& name, double radius);

/// The name of the side of the table from which a cushion's normal points: "back" for -y; empty for
/// jaws and rounded ends.
[[nodiscard]] std::string side_of(const Vec3& normal);

/// Reads the legs of a ball from events that come one after the other. Impacts with the cloth end
/// none.
class LegReader {
  public:
    LegReader(std::string ball, double radius) : ball_(std::move(ball)), radius_(radius) {}

    void see(const sim::Event& event);

    /// Those that have ended, in order.
    [[nodiscard]] const std::vector<Leg>& ended() const { return ended_; }
    /// Those and the last one, as far as it is known.
    [[nodiscard]] std::vector<Leg> legs() const;

  private:
    [[nodiscard]] std::uint64_t& cause_of(const std::string& ball);
    void note_cause(const sim::Event& event);
    void close(std::vector<Leg>& legs) const;

    std::string ball_;
    double radius_;
    std::map<std::string, std::uint64_t> causes_;  // what has led each ball to its present motion
    std::vector<Leg> ended_;
    std::optional<Leg> open_;
    Vec2 last_{0, 0};
    double last_cushion_ = -1;  // s
};

/// The legs of a ball, in order.
[[nodiscard]] std::vector<Leg> legs_of(const std::string& ball, std::span<const sim::Event> events,
                                       const Radii& radii);

}  // namespace carom::pipeline::solve
