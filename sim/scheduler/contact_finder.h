// Finds the contacts of the bodies in ODE, with each other and with the static environment.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "sim/ode/step_world.h"
#include "sim/scheduler/static_environment.h"
#include "sim/scheduler/step_body.h"

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

class ContactFinder {
  public:
    explicit ContactFinder(const StaticEnvironment& environment) : environment_(environment) {}

    /// All contacts of awake bodies, in a fixed order.
    [[nodiscard]] std::vector<BodyContact> find(const std::vector<StepBody>& bodies) const;

    /// Name and material of the part of the static environment that a contact's `other` stands for.
    [[nodiscard]] SurfaceInfo info(int other) const;

  private:
    void find_for_ball(int number, const StepBody& ball, std::vector<BodyContact>& found) const;
    void find_for_solid(int number, const StepBody& body, std::vector<BodyContact>& found) const;
    void find_box_meshes(int number, const StepBody& box, const Aabb& bounds,
                         std::vector<BodyContact>& found) const;
    void find_meshes(int number, const StepBody& body, const Aabb& bounds,
                     std::vector<BodyContact>& found) const;
    void find_on_ground(int number, const StepBody& body, std::vector<BodyContact>& found) const;
    [[nodiscard]] static std::vector<SurfaceContact> solid_contacts(const PlacedShape& a,
                                                                    const PlacedShape& b);
    void find_between(int a, const StepBody& first, int b, const StepBody& second,
                      std::vector<BodyContact>& found) const;
    void add(int number, const StepBody& body, int other, MaterialId other_material,
             const SurfaceContact& contact, std::vector<BodyContact>& found) const;

    const StaticEnvironment& environment_;
};

}  // namespace carom::sim
