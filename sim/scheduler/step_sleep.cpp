#include "sim/scheduler/step_sleep.h"

#include <algorithm>
#include <numeric>
#include <unordered_map>
#include <utility>

#include "core/length.h"
#include "sim/numeric/tolerances.h"

namespace carom::sim {
namespace {

/// A body that is slow (kSleepSpeed) and does not creep (kCreep) for this long (s) falls asleep. A
/// solid that turns back in the middle of it accelerates by less than 0.11 m/s^2. All that waits
/// for its sleep is solved together, in a time that grows with the cube of its contacts.
constexpr double kBallSleepDelay = 0.1;
constexpr double kSolidSleepDelay = 0.06;
/// A body that leans on something without stable support, and does not slide for this long (s), is
/// held by friction.
constexpr double kLeaningSleepDelay = 0.5;

/// A body may creep this far (m) while it counts as standing, so that what sleeps beside it may
/// stand off by as much before it wakes.
constexpr double kCreep = 5e-5;

std::size_t index(int number) {
    return static_cast<std::size_t>(number);
}

/// The islands of an instant, as a forest whose roots stand for them.
class Islands {
  public:
    explicit Islands(std::size_t count) : parents_(count) {
        std::iota(parents_.begin(), parents_.end(), 0);
    }

    void join(int a, int b) { parents_[index(root(a))] = root(b); }

    [[nodiscard]] int root(int number) {
        while (parents_[index(number)] != number) {
            number = parents_[index(number)] = parents_[index(parents_[index(number)])];
        }
        return number;
    }

  private:
    std::vector<int> parents_;
};

}  // namespace

bool StepSleep::wake_by_contact(const std::vector<BodyContact>& contacts, double time) {
    bool is_changed = false;
    for (const BodyContact& found : contacts) {
        if (!found.is_between_bodies()) {
            continue;
        }
        const bool is_first_awake = body(found.contact.first).is_in_solver();
        const int sleeper = is_first_awake ? found.contact.second : found.contact.first;
        const MovingBody& other = body(is_first_awake ? found.contact.first : found.contact.second);
        if (body(sleeper).is_in_solver() || !is_movable(sleeper)) {
            continue;
        }
        if (other.is_kinematic() || other.is_restless || other.max_point_speed() >= kSleepSpeed) {
            bodies_.wake(static_cast<std::uint32_t>(sleeper), time);
            is_changed = true;
        }
    }
    return is_changed;
}

bool StepSleep::is_movable(int number) {
    return number >= 0 && !body(number).is_kinematic();
}

/// A body has to be slow, without creeping, and in contact. None of its island may touch a
/// kinematic body that moves: on that it would creep for ever.
void StepSleep::update_rest_timers(const std::vector<int>& moving, const SolvedContacts& solved,
                                   double time) {
    std::vector<char> rests(bodies_.all().size(), 0);
    Islands islands(bodies_.all().size());
    for (const BodyContact& found : solved.contacts) {
        rests[index(found.contact.first)] = 1;
        if (found.is_between_bodies()) {
            rests[index(found.contact.second)] = 1;
            if (is_movable(found.contact.first) && is_movable(found.contact.second)) {
                islands.join(found.contact.first, found.contact.second);
            }
        }
    }
    std::vector<char> is_driven(bodies_.all().size(), 0);  // by the root of an island
    for (const BodyContact& found : solved.contacts) {
        for (const auto& [number, partner] :
             {std::pair(found.contact.first, found.contact.second),
              std::pair(found.contact.second, found.contact.first)}) {
            if (number >= 0 && partner >= 0 && body(partner).is_kinematic() &&
                body(partner).is_in_solver()) {
                is_driven[index(islands.root(number))] = 1;
            }
        }
    }
    for (const int number : moving) {
        MovingBody& moved = body(number);
        const double speed = moved.max_point_speed();
        moved.is_restless = rests[index(number)] == 0 || is_driven[index(islands.root(number))] ||
                            speed >= kSleepSpeed || moved.distance_from(moved.slow_at) > kCreep;
        if (moved.is_restless) {
            moved.restart_rest_timer(time);
            leave_island(number, time);
        }
        moved.least_speed = std::min(moved.least_speed, speed);
    }
}

/// A body that moves wakes those that it has touched: they may have lost each other in one step.
void StepSleep::leave_island(int number, double time) {
    MovingBody& moved = body(number);
    const std::uint32_t island = std::exchange(moved.island, 0);
    for (std::uint32_t i = 0; island != 0 && i < bodies_.all().size(); ++i) {
        const MovingBody& other = bodies_.all()[i];
        const double reach = moved.bounding_radius() + other.bounding_radius() + kSolidMargin;
        if (other.island == island && length(other.state.position - moved.state.position) < reach) {
            bodies_.wake(i, time);
        }
    }
}

bool StepSleep::is_held(int number, const SolvedContacts& solved, std::span<const std::size_t> own,
                        double time) {
    const MovingBody& held = body(number);
    const double rested = time - held.slow_since;
    const bool is_rising = held.max_point_speed() > held.least_speed + kRisingSpeed;
    const bool is_supported = is_stably_supported(held, number, solved, own, gravity_) ||
                              (rested > kLeaningSleepDelay && leans(number, solved, own, gravity_));
    return (!is_rising && is_supported) || rested > time_to_tip(held, gravity_);
}

bool StepSleep::is_quiet(int number, double time) {
    const double delay = body(number).is_ball() ? kBallSleepDelay : kSolidSleepDelay;
    return !body(number).is_in_solver() || time - body(number).slow_since > delay;
}

std::vector<int> StepSleep::falling_asleep(const std::vector<int>& moving,
                                           const SolvedContacts& solved, double time) {
    update_rest_timers(moving, solved, time);
    std::vector<char> is_disturbed(bodies_.all().size(), 0);
    for (const BodyContact& found : solved.contacts) {
        const int first = found.contact.first;
        const int second = found.contact.second;
        if (!is_movable(first) || !is_movable(second)) {
            continue;
        }
        if (!is_quiet(second, time)) {
            is_disturbed[index(first)] = 1;
        }
        if (!is_quiet(first, time)) {
            is_disturbed[index(second)] = 1;
        }
    }
    const ContactsOfBodies contacts(solved.contacts, bodies_.all().size());
    std::vector<int> asleep;
    for (const int number : moving) {
        if (is_movable(number) && is_quiet(number, time) && is_disturbed[index(number)] == 0 &&
            is_held(number, solved, contacts.of(number), time)) {
            asleep.push_back(number);
        }
    }
    if (!asleep.empty()) {
        join_islands(asleep, solved);
    }
    return asleep;
}

/// The bodies that fall asleep, what they touch and the islands of both become one.
void StepSleep::join_islands(const std::vector<int>& asleep, const SolvedContacts& solved) {
    std::vector<char> falls_asleep(bodies_.all().size(), 0);
    for (const int number : asleep) {
        falls_asleep[index(number)] = 1;
    }
    Islands islands(bodies_.all().size());
    for (const BodyContact& found : solved.contacts) {
        const auto& [first, second] = std::pair(found.contact.first, found.contact.second);
        if (is_movable(first) && is_movable(second) &&
            (falls_asleep[index(first)] != 0 || falls_asleep[index(second)] != 0)) {
            islands.join(first, second);
        }
    }
    std::unordered_map<std::uint32_t, int> member_of;
    for (int number = 0; number < static_cast<int>(bodies_.all().size()); ++number) {
        if (body(number).island != 0) {
            islands.join(member_of.try_emplace(body(number).island, number).first->second, number);
        }
    }
    std::vector<std::uint32_t> names(bodies_.all().size(), 0);  // by the root
    for (const int number : asleep) {
        std::uint32_t& name = names[index(islands.root(number))];
        name = name != 0 ? name : ++island_count_;
    }
    for (int number = 0; number < static_cast<int>(bodies_.all().size()); ++number) {
        if (const std::uint32_t name = names[index(islands.root(number))]; name != 0) {
            body(number).island = name;
        }
    }
}

}  // namespace carom::sim
