#include "shot_checks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>

#include "core/finite.h"
#include "rest_checks.h"
#include "sim/billiards/table.h"
#include "sim/timeline/energy.h"

namespace carom::sim::test {
namespace {

template <class... Values>
std::string text(const char* format, Values... values) {
    std::array<char, 300> buffer{};
    std::snprintf(buffer.data(), buffer.size(), format, values...);
    return buffer.data();
}

/// True for warnings that a valid shot may have: events that miss, miscue or never happen, and
/// balls that others keep from being potted; not for those about the simulation or kinematic
/// bodies.
bool is_harmless(const Diagnostic& warning) {
    return warning.subject.kind == Subject::Kind::event ||
           (warning.subject.kind == Subject::Kind::body && warning.field.empty());
}

void check_warnings(const Timeline& timeline, std::vector<std::string>& faults) {
    for (const Diagnostic& warning : timeline.warnings) {
        if (!is_harmless(warning)) {
            faults.push_back("warning: " + warning.sentence);
        }
    }
}

/// The solid parts of a world, for tests of where a ball may be.
class Solids {
  public:
    Solids(const billiards::TableMeasures& table, double radius)
        : table_(table), radius_(radius), geometry_(billiards::build_table(table, radius)) {}

    /// Depth (m) of a ball inside a solid; 0 outside. `has_left`: the ball has left the table over
    /// its rails; from the floor it may get under the table.
    [[nodiscard]] double depth(const Vec3& p, bool has_left) const {
        const Vec2 level(p.x, p.y);
        const Vec2 field(0.5 * table_.length, 0.5 * table_.width);
        const double beyond = std::max(std::abs(p.x) - field.x, std::abs(p.y) - field.y);
        const double outer = table_.cushion_width + table_.rail_width;
        const double to_pocket = distance_to_pocket(level);
        if (to_pocket < 0 || beyond > outer || (has_left && p.z < 0)) {
            return 0;
        }
        // Above the nose's height a ball may be over the cushion; in a pocket's mouth, beside it.
        const bool is_in_mouth = to_pocket < 3 * radius_;
        if (beyond > 0 && !is_in_mouth) {
            return std::max(table_.nose_height + radius_ * 0.7 - p.z, 0.0);
        }
        return std::max({radius_ - p.z, in_nose(p), 0.0});
    }

  private:
    [[nodiscard]] double in_nose(const Vec3& p) const {
        const double rise = table_.nose_height - p.z;
        if (std::abs(rise) >= radius_) {
            return 0;
        }
        const double contact_distance = std::sqrt(radius_ * radius_ - rise * rise);
        const Vec2 level(p.x, p.y);
        double deepest = 0;
        for (const billiards::CushionFace& face : geometry_.faces) {
            const Vec2 along = face.to - face.from;
            const double place = (level - face.from).dot(along) / along.dot(along);
            const double distance = (level - face.from).dot(face.normal);
            const bool is_over_it = distance < 0 && rise < 0;
            if (place >= 0 && place <= 1 && distance > -radius_ && !is_over_it) {
                deepest = std::max(deepest, contact_distance - distance);
            }
        }
        for (const billiards::CushionCorner& corner : geometry_.corners) {
            deepest = std::max(deepest,
                               contact_distance + corner.radius - (level - corner.centre).length());
        }
        return deepest;
    }
    [[nodiscard]] double distance_to_pocket(const Vec2& place) const {
        double least = 1e9;
        for (const billiards::Pocket& pocket : geometry_.pockets) {
            least = std::min(least, (place - pocket.centre).length() - pocket.radius);
        }
        return least;
    }

    const billiards::TableMeasures& table_;
    double radius_;
    billiards::TableGeometry geometry_;
};

/// The time at which the ball finally left the table; 1e9 if it did not.
double off_table_time(const Timeline& timeline, const std::string& ball) {
    for (const Event& event : timeline.events) {
        if (event.kind == EventKind::off_table && event.a == ball) {
            return event.time;
        }
    }
    return 1e9;
}

/// Whether an event has taken the ball off the table, and none has put it back yet.
bool is_taken_off(const Timeline& timeline, const std::string& ball, double time) {
    bool is_off = false;
    for (const Event& event : timeline.events) {
        if (event.time <= time && event.a == ball &&
            (event.kind == EventKind::removed || event.kind == EventKind::placed)) {
            is_off = event.kind == EventKind::removed;
        }
    }
    return is_off;
}

void check_places(const WorldDescription& world, const Timeline& timeline,
                  std::vector<std::string>& faults) {
    if (!world.table || !world.table->has_cushions) {
        return;
    }
    constexpr double kAllowed = 2e-4;  // m: ODE's contacts yield slightly
    std::map<double, Solids> by_radius;
    for (const Body& body : world.bodies) {
        const auto* sphere = std::get_if<Sphere>(&body.shape);
        if (sphere == nullptr) {
            continue;
        }
        const Solids& solids =
            by_radius.try_emplace(sphere->radius, *world.table, sphere->radius).first->second;
        const Track& track = *timeline.find(body.name);
        const double left = off_table_time(timeline, body.name);
        // No ball crosses the rails between two samples.
        for (double time = 0; time < world.duration; time += 1.0 / 240) {
            const Vec3 p = track.sample(time).position;
            const double depth = solids.depth(p, time >= left);
            if (depth > kAllowed && !is_taken_off(timeline, body.name, time)) {
                faults.push_back(text("'%s' is %.3f mm inside at %.4f s, (%.4f, %.4f, %.4f)",
                                      body.name.c_str(), depth * 1e3, time, p.x, p.y, p.z));
                break;
            }
        }
    }
}

/// Whether a ball leaves or has left through a pocket's floor: it passes through everything. From
/// its start there, its fall is one piece of its track.
bool is_returned(const WorldDescription& world, const Track& track, double time, double radius) {
    if (!world.table || !world.table->has_ball_return) {
        return false;
    }
    constexpr double kBelow = 1e-4;  // m; a strong force presses a ball in by 0.03 mm
    const auto is_below = [&](const Vec3& place,
                              const std::optional<billiards::PocketMeasures>& pocket) {
        return pocket && place.z < radius - pocket->drop - kBelow;
    };
    const auto is_below_floor = [&](const Vec3& place) {
        return is_below(place, world.table->corner_pocket) ||
               is_below(place, world.table->side_pocket);
    };
    const auto next = std::find_if(track.keys().begin(), track.keys().end(),
                                   [time](const Key& key) { return key.time > time; });
    return is_below_floor(track.sample(time).position) ||
           (next != track.keys().end() && is_below_floor(next->position));
}

/// Reports pairs of overlapping balls.
void check_pairs(const WorldDescription& world, const Timeline& timeline,
                 std::vector<std::string>& faults) {
    constexpr double kAllowed = 2e-4;  // m
    struct Placed {
        const Body* body;
        double radius;
        const Track* track;  // nullptr for a fixed ball
        Vec3 place;
    };
    const auto has_left = [&](const Placed& ball, double time) {
        return ball.track != nullptr && is_returned(world, *ball.track, time, ball.radius);
    };
    std::vector<Placed> balls;
    for (const Body& body : world.bodies) {
        if (const auto* sphere = std::get_if<Sphere>(&body.shape)) {
            balls.push_back({&body, sphere->radius, timeline.find(body.name), body.pose.position});
        }
    }
    for (int k = 0; k <= 40; ++k) {
        const double time = world.duration * k / 40;
        for (std::size_t i = 0; i < balls.size(); ++i) {
            if (balls[i].track != nullptr) {
                balls[i].place = balls[i].track->sample(time).position;
            }
            for (std::size_t j = 0; j < i; ++j) {
                const double depth =
                    balls[i].radius + balls[j].radius - (balls[i].place - balls[j].place).length();
                if (depth <= kAllowed || has_left(balls[i], time) || has_left(balls[j], time)) {
                    continue;
                }
                faults.push_back(text("'%s' is %.3f mm in '%s' at %.4f s, z %.4f",
                                      balls[i].body->name.c_str(), depth * 1e3,
                                      balls[j].body->name.c_str(), time, balls[i].place.z));
                return;
            }
        }
    }
}

/// The energy (J) that ODE's contacts return when forces end: a force of many times its weight
/// presses a ball into what it lies on, by up to this depth (m).
double energy_of_pressed_balls(const WorldDescription& world) {
    constexpr double kDepth = 1e-4;
    double energy = 0;
    for (const ForceEvent& event : world.events) {
        for (const Body& body : world.bodies) {
            if (std::holds_alternative<Force>(event.action) && body.name == event.object) {
                energy += body.mass * world.gravity.length() * kDepth;
            }
        }
    }
    return energy;
}

void check_energy(const WorldDescription& world, const Timeline& timeline,
                  std::vector<std::string>& faults) {
    const bool has_solids =
        std::any_of(world.bodies.begin(), world.bodies.end(),
                    [](const Body& b) { return !std::holds_alternative<Sphere>(b.shape); });
    // With balls in pockets or on rails, ODE's contacts with meshes are involved.
    const bool has_left =
        std::any_of(timeline.events.begin(), timeline.events.end(), [](const Event& event) {
            return event.kind == EventKind::potted || event.kind == EventKind::airborne;
        });
    const double allowed = has_solids || has_left ? 1e-6 : 1e-9;
    const double rise = largest_energy_rise(timeline);
    const double gain = largest_energy_gain(timeline);
    // Every impact separates at 0.05 mm/s at least, which is up to 1e-10 J for a pair: much for a
    // shot whose energy is less than a millijoule.
    constexpr double kSeparationEnergy = 1e-9;  // J
    const bool is_pressed = has_left && gain <= energy_of_pressed_balls(world);
    if (!(rise <= allowed) && !(gain <= kSeparationEnergy) && !is_pressed) {
        faults.push_back(text("energy rises by %.3g of the kinetic energy%s", rise,
                              has_solids ? ", with solids" : ""));
    }
}

void check_values(const Timeline& timeline, std::vector<std::string>& faults) {
    for (const Track& track : timeline.tracks) {
        for (const Key& key : track.keys()) {
            if (!is_finite(key.position) || !is_finite(key.velocity_out) ||
                !is_finite(key.angular_velocity_out)) {
                faults.push_back(
                    text("'%s' is not finite at %.6f s", track.name().c_str(), key.time));
                break;
            }
        }
    }
}

/// Contacts of a pair do not overlap, and there are hardly more than fifty a second; those of
/// bodies that touch and part in turns are shorter.
void check_contacts(const Timeline& timeline, std::vector<std::string>& faults) {
    std::map<std::pair<std::string, std::string>, std::pair<double, int>> pairs;
    for (const LastingContact& contact : timeline.lasting_contacts) {
        auto& [end, count] = pairs[{contact.a, contact.b}];
        const bool is_good = contact.from >= end && contact.to > contact.from &&
                             contact.to <= timeline.end_time + 1e-9 && contact.normal_force > 0 &&
                             std::isfinite(contact.normal_force) && contact.slip >= 0 &&
                             std::isfinite(contact.slip);
        if (!is_good) {
            faults.push_back(text("contact of '%s' and '%s' from %.6f to %.6f s, %g N, %g m/s",
                                  contact.a.c_str(), contact.b.c_str(), contact.from, contact.to,
                                  contact.normal_force, contact.slip));
        }
        end = contact.to;
        ++count;
    }
    for (const auto& [names, contacts] : pairs) {
        if (contacts.second > 10 + 250 * (timeline.end_time - timeline.start_time)) {
            faults.push_back(text("%d contacts of '%s' and '%s'", contacts.second,
                                  names.first.c_str(), names.second.c_str()));
        }
    }
}

/// Whatever is at rest is held, at five instants.
void check_rest(const WorldDescription& world, const Timeline& timeline,
                std::vector<std::string>& faults) {
    for (int k = 1; k <= 5; ++k) {
        // After its last key, which rounding may put before the end, a track stands still.
        const double time = (world.duration - 1e-6) * k / 5;
        const auto takes_part = [&](const Body& body) {
            const auto* sphere = std::get_if<Sphere>(&body.shape);
            return sphere == nullptr ||
                   (!is_taken_off(timeline, body.name, time) &&
                    !is_returned(world, *timeline.find(body.name), time, sphere->radius));
        };
        for (const std::string& fault : find_unheld(world, timeline, time, takes_part)) {
            faults.push_back(fault + text(" at %.4f s", time));
        }
    }
}

}  // namespace

std::vector<std::string> find_faults(const WorldDescription& world, const Timeline& timeline) {
    std::vector<std::string> faults;
    check_warnings(timeline, faults);
    check_values(timeline, faults);
    check_places(world, timeline, faults);
    check_pairs(world, timeline, faults);
    check_energy(world, timeline, faults);
    check_contacts(timeline, faults);
    check_rest(world, timeline, faults);
    return faults;
}

}  // namespace carom::sim::test
