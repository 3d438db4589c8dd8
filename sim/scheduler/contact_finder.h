// Finds the contacts of the bodies in ODE, with each other and with the static environment.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "sim/numeric/tolerances.h"
#include "sim/ode/step_world.h"
#include "sim/scheduler/moving_body.h"
#include "sim/scheduler/near_pairs.h"
#include "sim/scheduler/static_environment.h"

namespace carom::sim {

/// A triangle surface or solid, an index into StaticEnvironment::surfaces.
struct StaticSurface {
    std::uint32_t index = 0;
    bool operator==(const StaticSurface&) const = default;
    [[nodiscard]] bool operator<(const StaticSurface& other) const { return index < other.index; }
};
/// A fixed sphere, an index into StaticEnvironment::spheres.
struct StaticSphere {
    std::uint32_t index = 0;
    bool operator==(const StaticSphere&) const = default;
    [[nodiscard]] bool operator<(const StaticSphere& other) const { return index < other.index; }
};
/// Another moving body, an index in Bodies.
struct OtherBody {
    int index = 0;
    bool operator==(const OtherBody&) const = default;
    [[nodiscard]] bool operator<(const OtherBody& other) const { return index < other.index; }
};
/// What a body touches.
using ContactPartner = std::variant<SupportPlane, StaticSurface, StaticSphere, OtherBody>;

/// The number of a body, and what it touches.
using ContactPair = std::pair<int, ContactPartner>;

/// A contact of a body in the solver.
struct BodyContact {
    ode::StepContact contact;
    ContactPartner partner;

    [[nodiscard]] ContactPair pair() const { return {contact.first, partner}; }
    [[nodiscard]] bool is_between_bodies() const { return contact.second >= 0; }
};

/// Where the bodies are now.
[[nodiscard]] std::vector<Placement> placements_of(std::span<const MovingBody> bodies);

/// The widest gap of bodies that one impact may close, m.
inline constexpr double kMaxReach = 5e-3;

class ContactFinder {
  public:
    explicit ContactFinder(const StaticEnvironment& environment) : environment_(environment) {}

    /// All contacts of the bodies in the solver, in a fixed order. `placed`: the bodies'
    /// placements, in the same order. Where nothing has moved since the last call, as at the start
    /// of a step whose end was looked at, they are those found then. Valid until the next call.
    [[nodiscard]] const std::vector<BodyContact>& find(std::span<const MovingBody> bodies,
                                                       std::span<const Placement> placed);
    /// Likewise, with gaps up to `reach` (m, at most kMaxReach), except those with meshes.
    [[nodiscard]] std::vector<BodyContact> find_within(double reach,
                                                       std::span<const MovingBody> bodies,
                                                       std::span<const Placement> placed);

    /// Name and material of a part of the static environment.
    [[nodiscard]] SurfaceInfo info(const ContactPartner& partner) const;
    /// Name of what a body touches.
    [[nodiscard]] std::string name_of(const ContactPartner& partner,
                                      std::span<const MovingBody> bodies) const;

  private:
    /// A body in a state.
    struct Placed {
        int number;
        const MovingBody& body;
        const MotionState& state;
        double reach;

        [[nodiscard]] PlacedShape shape() const { return body.placed(state); }
        /// The gap up to which it has contacts, m.
        [[nodiscard]] double margin() const {
            return std::max(reach, body.is_ball() ? kBallMargin : kSolidMargin);
        }
    };
    void find_for_ball(const Placed& ball, std::vector<BodyContact>& found);
    void find_for_solid(const Placed& solid, std::vector<BodyContact>& found) const;
    void find_box_meshes(const Placed& box, const Aabb& bounds,
                         std::vector<BodyContact>& found) const;
    void find_meshes(const Placed& solid, const Aabb& bounds,
                     std::vector<BodyContact>& found) const;
    void find_on_ground(const Placed& solid, std::vector<BodyContact>& found) const;
    [[nodiscard]] static std::vector<Contact> solid_contacts(const PlacedShape& a,
                                                             const PlacedShape& b, double margin);
    void find_between(const Placed& first, const Placed& second,
                      std::vector<BodyContact>& found) const;
    /// How a body can roll on a contact.
    struct Rolling {
        double length = 0;  // MovingBody::rolling_length; 0 if it cannot
        bool is_ball = false;
        Vec3 axis{0, 0, 0};  // StepContact::rolling_axis
    };
    /// Cylinders and capsules roll about their axis: on their curved side and along their
    /// rims. They tip over rims and round ends without resistance.
    [[nodiscard]] static Rolling rolling_of(const Placed& placed, const Vec3& normal);
    void add(const Placed& placed, const ContactPartner& partner, MaterialId partner_material,
             const Contact& contact, std::vector<BodyContact>& found) const;
    void add(const Placed& first, const Placed& second, const Contact& contact,
             std::vector<BodyContact>& found) const;
    void add(const Placed& placed, const ContactPartner& partner, MaterialId partner_material,
             const Contact& contact, const Rolling& rolling, std::vector<BodyContact>& found) const;

    const StaticEnvironment& environment_;
    std::vector<Placement> last_placed_;
    std::vector<BodyContact> last_found_;
    NearPairs near_pairs_{kSolidMargin};
    NearPairs wide_pairs_{kMaxReach};
    /// Per ball, those of the table and of the scenery.
    std::vector<std::array<StaticMesh::NearFeatures, 2>> near_features_;
};

}  // namespace carom::sim
