#include "sim/scheduler/step_loads.h"

#include <algorithm>
#include <map>
#include <utility>

#include "core/length.h"
#include "core/rigid.h"

namespace carom::sim {
namespace {

/// The mean motion of a body in a step: its velocities change once, at the midpoint.
class MeanMotion {
  public:
    MeanMotion(const ToiSubstep& trial, int number) {
        const auto& moving = trial.moving();
        const auto found = std::lower_bound(moving.begin(), moving.end(), number);
        if (number < 0 || found == moving.end() || *found != number) {
            return;
        }
        const auto slot = static_cast<std::size_t>(found - moving.begin());
        const MotionState& before = trial.midpoints()[slot];
        const MotionState& after = trial.motions()[slot].after;
        position_ = after.position;
        velocity_ = (before.velocity + after.velocity) * 0.5;
        turning_ = (before.angular_velocity + after.angular_velocity) * 0.5;
    }

    [[nodiscard]] Vec3 velocity_at(const Vec3& point) const {
        return velocity_ + turning_.cross(point - position_);
    }
    [[nodiscard]] const Vec3& turning() const { return turning_; }

  private:
    Vec3 position_{0, 0, 0};
    Vec3 velocity_{0, 0, 0};
    Vec3 turning_{0, 0, 0};
};

double smaller_radius(const std::vector<MovingBody>& bodies, const BodyContact& found) {
    const double first = bodies[static_cast<std::size_t>(found.contact.first)].bounding_radius();
    return !found.is_between_bodies()
               ? first
               : std::min(first,
                          bodies[static_cast<std::size_t>(found.contact.second)].bounding_radius());
}

}  // namespace

std::vector<PairLoad> pair_loads(const ToiSubstep& trial, const std::vector<MovingBody>& bodies) {
    std::vector<PairLoad> loads;
    std::map<ContactPair, std::size_t> places;
    const SolvedContacts solved = trial.solved();
    for (std::size_t i = 0; i < solved.contacts.size(); ++i) {
        const BodyContact& found = solved.contacts[i];
        const double impulse = solved.impulses[i].normal;
        if (!(impulse > 0)) {
            continue;
        }
        const MeanMotion first(trial, found.contact.first);
        const MeanMotion second(trial, found.contact.second);
        const Vec3& point = found.contact.point;
        const Vec3& normal = found.contact.normal;
        const Vec3 relative = first.velocity_at(point) - second.velocity_at(point);
        const auto [place, is_new] = places.try_emplace(found.pair(), loads.size());
        if (is_new) {
            const double turning =
                length(first.turning() - second.turning()) * smaller_radius(bodies, found);
            loads.push_back(
                {found.contact.first, found.partner, {trial.start(), trial.end(), 0, 0, turning}});
        }
        ContactLoad& load = loads[place->second].load;
        load.normal_impulse += impulse;
        load.slip += impulse * length(across(relative, normal));
    }
    for (PairLoad& pair : loads) {
        pair.load.slip /= pair.load.normal_impulse;
    }
    return loads;
}

}  // namespace carom::sim
