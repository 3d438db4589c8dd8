// Finds the contacts of the bodies in ODE, with each other and with the static environment.
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "sim/ode/step_world.h"
#include "sim/scheduler/moving_body.h"
#include "sim/scheduler/static_environment.h"

namespace carom::sim {

/// Negative numbers that stand for the static environment as the second body of a contact.
inline constexpr int kCloth = -1;
inline constexpr int kFloor = -2;
inline constexpr int kFirstSurface = -10;     // - index into StaticEnvironment::surfaces
inline constexpr int kFirstFixed = -1000000;  // - index of a fixed sphere

/// A contact of a body in ODE with another one or with the static environment.
struct BodyContact {
    ode::StepContact contact;  // `second` is -1 for the static environment
    int other = kCloth;        // the second body, or one of the numbers above

    [[nodiscard]] std::pair<int, int> pair() const { return {contact.first, other}; }
};

/// Where a body is at an instant of a step, and in which mode it was when the step began.
struct Placement {
    MotionState state;
    Mode mode = Mode::gone;

    [[nodiscard]] bool is_in_solver() const { return mode == Mode::solver; }
    [[nodiscard]] bool is_collidable() const { return is_in_solver() || mode == Mode::asleep; }
};

/// Where the bodies are now.
[[nodiscard]] std::vector<Placement> placements_of(std::span<const MovingBody> bodies);

class ContactFinder {
  public:
    explicit ContactFinder(const StaticEnvironment& environment) : environment_(environment) {}

    /// All contacts of the bodies in the solver, in a fixed order. `placed`: the bodies'
    /// placements, in the same order.
    [[nodiscard]] std::vector<BodyContact> find(std::span<const MovingBody> bodies,
                                                std::span<const Placement> placed) const;
    /// Likewise where the bodies are now.
    [[nodiscard]] std::vector<BodyContact> find(std::span<const MovingBody> bodies) const {
        return find(bodies, placements_of(bodies));
    }

    /// Name and material of the part of the static environment that a contact's `other` stands for.
    [[nodiscard]] SurfaceInfo info(int other) const;

  private:
    /// A body in a state.
    struct Placed {
        int number;
        const MovingBody& body;
        const MotionState& state;

        [[nodiscard]] PlacedShape shape() const { return body.placed(state); }
    };
    void find_for_ball(const Placed& ball, std::vector<BodyContact>& found) const;
    void find_for_solid(const Placed& solid, std::vector<BodyContact>& found) const;
    void find_box_meshes(const Placed& box, const Aabb& bounds,
                         std::vector<BodyContact>& found) const;
    void find_meshes(const Placed& solid, const Aabb& bounds,
                     std::vector<BodyContact>& found) const;
    void find_on_ground(const Placed& solid, std::vector<BodyContact>& found) const;
    [[nodiscard]] static std::vector<SurfaceContact> solid_contacts(const PlacedShape& a,
                                                                    const PlacedShape& b);
    void find_between(const Placed& first, const Placed& second,
                      std::vector<BodyContact>& found) const;
    void add(const Placed& placed, int other, MaterialId other_material,
             const SurfaceContact& contact, std::vector<BodyContact>& found) const;

    const StaticEnvironment& environment_;
};

}  // namespace carom::sim
