// How players aim, as plane geometry: the ghost ball, the way into a pocket and what lies in it.
// Spin and throw are not part of it; find_aims.h adds what they do.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/vectors.h"
#include "sim/billiards/free_place.h"
#include "sim/billiards/table.h"

namespace carom::sim {

/// The angle of a vector, counter-clockwise from +x, in (-pi, pi].
[[nodiscard]] double angle_of(const Vec2& vector);
[[nodiscard]] Vec2 unit_at(double angle);
/// The angle, turned by whole revolutions into (-pi, pi].
[[nodiscard]] double wrapped(double angle);

/// The distance of the centres of two balls that lie on the cloth and touch, seen from above.
[[nodiscard]] double touching_distance(double radius, double other_radius);

/// The direction in which a ball at `from` passes a ball at `to` with its centre's path by `offset`
/// (m) to the left of the other's centre; empty if the balls are nearer than that.
[[nodiscard]] std::optional<double> passing_direction(const Vec2& from, const Vec2& to,
                                                      double offset);

/// The mouth of a pocket, as a ball on the cloth meets it.
struct PocketMouth {
    std::string name;
    Vec2 centre{0, 0};                // of the hole
    Vec2 middle{0, 0};                // of the mouth
    Vec2 axis{0, 0};                  // unit, outwards
    std::array<Vec2, 2> ends{};       // centres of the rounded noses: left and right of the axis
    std::array<double, 2> nearest{};  // of a ball's centre to them, when it touches
};

[[nodiscard]] std::vector<PocketMouth> pocket_mouths(const billiards::TableMeasures& table,
                                                     double ball_radius);

/// The directions in which a ball rolls into a pocket between the noses, without touching one.
struct PocketWindow {
    double middle = 0;  // rad
    double width = 0;   // rad; not positive if there is none
};
[[nodiscard]] PocketWindow window_of(const PocketMouth& pocket, const Vec2& from);

/// The first of the balls that a ball of `radius` touches on its straight way; nullptr if none.
/// Those with the names `except` count as not there.
[[nodiscard]] const billiards::LyingBall* first_in_way(
    const std::vector<billiards::LyingBall>& balls, const Vec2& from, const Vec2& to, double radius,
    const std::vector<std::string_view>& except);

}  // namespace carom::sim
