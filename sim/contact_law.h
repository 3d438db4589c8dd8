// Restitution, friction and rolling resistance for each pair of physical materials.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>

namespace carom::sim {

enum class CushionModel {
    mirror,   // restitution along the horizontal normal, no friction: for tests
    han2005,  // Han, I.: Dynamics in Carom and Three Cushion Billiards, J. Mech. Sci. Tech. 19(4),
              // 2005
    mathavan2010,  // Mathavan, Jackson, Parkin: A theoretical analysis of billiard ball dynamics
                   // under cushion impacts, 2010
};

enum class BallFriction {
    constant,   // `friction` of the pair
    alciatore,  // 0.009951 + 0.108 exp(-1.088 v), v the relative surface speed in m/s (Alciatore,
                // TP A-14: a fit to Marlow 1995, Table 10)
};

struct BallCloth {
    double sliding_friction = 0.2;      // -, >= 0
    double rolling_friction = 0.01;     // -, >= 0: deceleration / g
    double spinning_friction = 0.0127;  // -, >= 0: spin decays at 5/2 mu g / R
    double restitution = 0.5;           // ball on slate, [0, 1]
    bool operator==(const BallCloth&) const = default;
};

struct BallBall {
    double restitution = 0.95;  // [0, 1]
    double friction = 0.05;     // -, >= 0; with the model `constant` only
    BallFriction friction_model = BallFriction::alciatore;
    double friction_factor = 1;  // >= 0; the state of the balls: more than 1 for dirty ones
    bool operator==(const BallBall&) const = default;
};

/// How the restitution of a cushion falls with the speed at which a ball approaches it,
/// perpendicular to the cushion. Up to the speed `above` the cushion is nearly rigid and the
/// restitution constant. By default it is constant at all speeds.
struct RestitutionFall {
    double above = 0;  // m/s, >= 0
    double slope = 0;  // decrease for each m/s, s/m, >= 0
    double least = 0;  // it falls no further than this, [0, 1]
    bool operator==(const RestitutionFall&) const = default;
};

struct BallCushion {
    CushionModel model = CushionModel::mathavan2010;
    double restitution = 0.98;  // of a slow ball, [0, 1]
    double friction = 0.14;     // -, >= 0
    RestitutionFall fall{};
    bool operator==(const BallCushion&) const = default;
};

/// A model with its published parameters, and the fall that docs/physics.md derives for it.
[[nodiscard]] BallCushion usual_cushion(CushionModel model);

/// The restitution for a ball that approaches at `speed` (m/s, perpendicular to the cushion).
[[nodiscard]] double restitution_at(const BallCushion& law, double speed);

/// The deceleration / g of cylinders and capsules that roll on a material of which nothing else is
/// known: more than of a wheel on a rail (0.001 to 0.0025), less than of a ball on a cloth (0.01).
inline constexpr double kUsualRollingFriction = 0.003;

/// Any two other materials.
struct PairContact {
    double restitution = 0.3;  // [0, 1]
    double friction = 0.4;     // Coulomb, >= 0
    /// Deceleration / g, >= 0. If it is not given, balls roll without resistance, and cylinders and
    /// capsules with kUsualRollingFriction.
    std::optional<double> rolling_friction;
    bool operator==(const PairContact&) const = default;
};

struct ContactLaw {
    BallCloth ball_cloth;
    BallBall ball_ball;
    BallCushion ball_cushion = usual_cushion(CushionModel::mathavan2010);
    PairContact otherwise;  // pairs neither named in `pairs` nor built in
    /// Names in alphabetical order. A ball with "floor", "pocket" (its lining and floor) and "rail"
    /// has built-in values (contact_law.cpp) that an entry here replaces. In an impact a pocket's
    /// lining removes the fraction `friction` of a ball's velocity along it and of its spin.
    std::map<std::pair<std::string, std::string>, PairContact> pairs;
    /// Keep the vertical part of ball-ball friction and of cushion impulses for balls on the cloth.
    bool hop = false;

    /// The law for two materials, in either order.
    [[nodiscard]] const PairContact& between(const std::string& a, const std::string& b) const;
};

}  // namespace carom::sim
