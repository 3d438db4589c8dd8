#include "sound/source/settling.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <variant>

#include "core/elementary.h"
#include "sim/timeline/track.h"

namespace carom::sound {
namespace {

/// The distance of the farthest point of a body from its centre, about, m.
double reach_of(const SoundBody& body) {
    if (const auto* ball = std::get_if<BallShape>(&body.shape)) {
        return ball->radius;
    }
    if (const auto* box = std::get_if<BoxShape>(&body.shape)) {
        return box->size.length() / 2;
    }
    return power(std::get<OtherShape>(body.shape).volume, 1.0 / 3);
}

/// How a body or a surface is at an instant.
enum class Stillness { fixed, unmoved, settling, moving };

/// A body that rests at the beginning.
struct Settler {
    const sim::Track* track = nullptr;
    MotionState start;
    double reach = 0;  // m
    double limit = 0;  // m, by which it moves while it settles

    [[nodiscard]] Stillness at(double time) const {
        const MotionState now = track->sample(time);
        const Quat turn = now.orientation * start.orientation.inverse();
        const double moved = (now.position - start.position).length() + 2 * turn.v.length() * reach;
        return moved == 0      ? Stillness::unmoved
               : moved < limit ? Stillness::settling
                               : Stillness::moving;
    }
};

class Settling {
  public:
    explicit Settling(const SoundShot& shot) {
        for (const SoundBody& body : shot.bodies) {
            const sim::Track* track = shot.timeline->find(body.name);
            if (track == nullptr) {
                continue;
            }
            const MotionState start = track->sample(shot.timeline->start_time);
            std::optional<Settler>& settler = bodies_[body.name];
            if (start.velocity.length() == 0 && start.angular_velocity.length() == 0) {
                // What keys move does not fall.
                const double limit = std::isinf(body.mass) ? 0 : kSettlingWay;
                settler = Settler{track, start, reach_of(body), limit};
            }
        }
    }

    /// Whether an event is a contact of what settles. In order of time.
    bool holds(const sim::Event& event) {
        if (event.kind == sim::EventKind::impact) {
            const Stillness a = stillness(event.a, event.time);
            const Stillness b = stillness(event.b, event.time);
            if (std::max(a, b) == Stillness::settling) {
                return true;
            }
            wake(event.a);
            wake(event.b);
        } else if (acts(event.kind)) {
            wake(event.a);
        }
        return false;
    }

  private:
    static bool acts(sim::EventKind kind) {
        return kind == sim::EventKind::strike || kind == sim::EventKind::force ||
               kind == sim::EventKind::torque || kind == sim::EventKind::impulse ||
               kind == sim::EventKind::velocity;
    }

    /// What has no track never moves.
    [[nodiscard]] Stillness stillness(std::string_view name, double time) const {
        const auto found = bodies_.find(name);
        if (found == bodies_.end()) {
            return Stillness::fixed;
        }
        return found->second ? found->second->at(time) : Stillness::moving;
    }

    void wake(std::string_view name) {
        if (const auto found = bodies_.find(name); found != bodies_.end()) {
            found->second.reset();
        }
    }

    std::unordered_map<std::string_view, std::optional<Settler>> bodies_;  // empty: it moves
};

}  // namespace

std::vector<bool> settling_contacts(const SoundShot& shot) {
    Settling settling(shot);
    std::vector<bool> result;
    result.reserve(shot.timeline->events.size());
    for (const sim::Event& event : shot.timeline->events) {
        result.push_back(settling.holds(event));
    }
    return result;
}

}  // namespace carom::sound
