#include "sim/scheduler/step_sleep.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "sim/numeric/tolerances.h"

namespace carom::sim {
namespace {

/// A body that is slow (kSleepSpeed) for this long (s) falls asleep.
constexpr double kBallSleepDelay = 0.1;
constexpr double kSolidSleepDelay = 0.12;
/// A body that leans on something without stable support, and does not slide for this long (s), is
/// held by friction.
constexpr double kLeaningSleepDelay = 0.5;

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
    [[nodiscard]] static std::size_t index(int number) { return static_cast<std::size_t>(number); }

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
        if (is_first_awake != body(found.contact.second).is_in_solver() && is_movable(sleeper)) {
            bodies_.wake(static_cast<std::uint32_t>(sleeper), time);
            is_changed = true;
        }
    }
    return is_changed;
}

bool StepSleep::is_movable(int number) {
    return number >= 0 && !body(number).is_kinematic();
}

/// A body has to be slow, and in contact, but neither with a kinematic body that moves nor with a
/// sleeping one, which is about to wake.
void StepSleep::update_rest_timers(const std::vector<int>& moving, const SolvedContacts& solved,
                                   double time) {
    std::vector<char> rests(bodies_.all().size(), 0);
    std::vector<char> is_disturbed(bodies_.all().size(), 0);
    for (const BodyContact& found : solved.contacts) {
        const int first = found.contact.first;
        rests[static_cast<std::size_t>(first)] = 1;
        if (!found.is_between_bodies()) {
            continue;
        }
        const int second = found.contact.second;
        rests[static_cast<std::size_t>(second)] = 1;
        for (const auto& [number, partner] : {std::pair(first, second), std::pair(second, first)}) {
            const MovingBody& other = body(partner);
            if (other.is_kinematic() == other.is_in_solver()) {
                is_disturbed[static_cast<std::size_t>(number)] = 1;
            }
        }
    }
    for (const int number : moving) {
        const auto i = static_cast<std::size_t>(number);
        MovingBody& moved = body(number);
        const double speed = moved.max_point_speed();
        if (rests[i] == 0 || is_disturbed[i] != 0 || speed >= kSleepSpeed) {
            moved.restart_rest_timer(time);
        }
        moved.least_speed = std::min(moved.least_speed, speed);
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

std::vector<int> StepSleep::falling_asleep(const std::vector<int>& moving,
                                           const SolvedContacts& solved, double time) {
    update_rest_timers(moving, solved, time);
    Islands islands(bodies_.all().size());
    for (const BodyContact& found : solved.contacts) {
        if (is_movable(found.contact.first) && is_movable(found.contact.second)) {
            islands.join(found.contact.first, found.contact.second);
        }
    }
    std::vector<int> candidates;
    std::vector<char> stays_awake(bodies_.all().size(), 0);  // by the root of an island
    for (const int number : moving) {
        if (!is_movable(number)) {
            continue;
        }
        candidates.push_back(number);
        const double delay = body(number).is_ball() ? kBallSleepDelay : kSolidSleepDelay;
        if (time - body(number).slow_since <= delay) {
            stays_awake[static_cast<std::size_t>(islands.root(number))] = 1;
        }
    }
    const ContactsOfBodies contacts(solved.contacts, bodies_.all().size());
    for (const int number : candidates) {
        char& stays = stays_awake[static_cast<std::size_t>(islands.root(number))];
        if (stays == 0 && !is_held(number, solved, contacts.of(number), time)) {
            stays = 1;
        }
    }
    std::erase_if(candidates, [&](int number) {
        return stays_awake[static_cast<std::size_t>(islands.root(number))] != 0;
    });
    for (const int number : candidates) {
        body(number).island = island_count_ + static_cast<std::uint32_t>(islands.root(number));
    }
    island_count_ += candidates.empty() ? 0 : static_cast<std::uint32_t>(bodies_.all().size());
    return candidates;
}

}  // namespace carom::sim
