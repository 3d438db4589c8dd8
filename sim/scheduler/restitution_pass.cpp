#include "sim/scheduler/restitution_pass.h"

#include <algorithm>
#include <string>

#include <fmt/core.h>

#include "sim/numeric/tolerances.h"
#include "sim/scheduler/contact_table.h"
#include "sim/scheduler/impact_group.h"

namespace carom::sim {
namespace {

/// What ODE solves between impacts is no more exact, and pairs that close more slowly than
/// kBounceSpeed are its own.
constexpr GroupPrecision kPrecision{40, 10, 0.05 * kBounceSpeed};

}  // namespace

void RestitutionPass::resolve(const std::vector<BodyContact>& contacts, double time) {
    constexpr int kMaxBounces = 1000;
    forget_jams(contacts);
    const auto state_of = [this](int number) -> const MotionState& { return body(number).state; };
    for (int i = 0; i < kMaxBounces; ++i) {
        const BodyContact* fastest = nullptr;
        double speed = kBounceSpeed;
        for (const BodyContact& found : contacts) {
            const bool is_ball = body(found.contact.first).is_ball();
            if ((!is_ball && found.contact.depth < -kClosedGap) || is_jammed(found)) {
                continue;
            }
            const double candidate = approach_speed(found, state_of);
            if (candidate > speed) {
                speed = candidate;
                fastest = &found;
            }
        }
        if (fastest == nullptr) {
            break;
        }
        bounce(*fastest, speed, time);
        count_impact(*fastest, time);
    }
    log_impacts(time);
}

/// A ball that meets one thing alone follows the law of pairs. So does one that meets the lining of
/// a pocket, which touches it much longer than anything else. If a kinematic body squeezes the
/// others, the impact of all has no end, and the pair is resolved alone.
void RestitutionPass::bounce(const BodyContact& found, double speed, double time) {
    const bool is_ball = body(found.contact.first).is_ball();
    if (is_on_lining(found)) {
        return bounce_ball(found, time);
    }
    std::vector<BodyContact> group = find_group(found, speed, time);
    if ((!is_ball || group.size() > 1) && bounce_group(group, time)) {
        return;
    }
    if (is_ball) {
        return bounce_ball(found, time);
    }
    std::erase_if(group, [&](const BodyContact& other) { return other.pair() != found.pair(); });
    bounce_group(group, time);
}

void RestitutionPass::forget_jams(const std::vector<BodyContact>& contacts) {
    kinematic_impact_counts_.clear();
    std::erase_if(jams_, [&](const ContactPair& jam) {
        return std::none_of(contacts.begin(), contacts.end(),
                            [&](const BodyContact& found) { return found.pair() == jam; });
    });
}

/// Repeated impacts between two free bodies die away, but a kinematic body never slows down.
void RestitutionPass::count_impact(const BodyContact& found, double time) {
    constexpr int kMaxImpacts = 50;
    if (!found.is_between_bodies()) {
        return;
    }
    const MovingBody& first = body(found.contact.first);
    const MovingBody& second = body(found.contact.second);
    if (!(first.is_kinematic() || second.is_kinematic()) ||
        ++kinematic_impact_counts_[found.pair()] < kMaxImpacts) {
        return;
    }
    jams_.insert(found.pair());
    const MovingBody& moved = first.is_kinematic() ? first : second;
    const MovingBody& caught = first.is_kinematic() ? second : first;
    if (!warned_pairs_.insert(found.pair()).second) {
        return;
    }
    recorder_.warn(
        {Subject::body(moved.name()), "motion",
         fmt::format("at {:.3f} s the path of '{}' leaves no room for '{}', which gets stuck: "
                     "change the path or move '{}'",
                     time, moved.name(), caught.name(), caught.name())});
}

void RestitutionPass::bounce_ball(const BodyContact& found, double time) {
    const ode::StepContact& contact = found.contact;
    MovingBody& ball = body(contact.first);
    MovingBody* other = found.is_between_bodies() ? &body(found.contact.second) : nullptr;
    ode::ImpactResult result;
    if (other != nullptr && other->is_kinematic()) {
        result =
            bodies_.impact_solver().solve_kinematic(ball, velocity_at(other->state, contact.point),
                                                    contact, contact.restitution, contact.friction);
    } else if (other != nullptr) {
        result = bodies_.impact_solver().solve(ball, *other, contact, contact.restitution,
                                               contact.friction);
    } else if (is_on_lining(found)) {
        RigidBody body = ball;
        result.impulse = lining_impact(body, contact.normal, contact.restitution, contact.friction);
        result.first = {body.state.velocity, body.state.angular_velocity};
    } else {
        result = bodies_.impact_solver().solve_static(ball, contact, contact.restitution,
                                                      contact.friction);
    }
    set_velocities(ball, result.first, time);
    if (other != nullptr) {
        set_velocities(*other, result.second, time);
    }
    recorder_.log_impact(time, ball.name(), finder_.name_of(found.partner, bodies_.all()),
                         contact.point, contact.normal, result.impulse);
}

/// All contacts of the bodies that touch, or may touch while the impact lasts, directly or through
/// others. Fixed and kinematic bodies join none.
std::vector<BodyContact> RestitutionPass::find_group(const BodyContact& found, double speed,
                                                     double time) {
    const double reach = reach_of(found, speed);
    for (;;) {
        std::vector<BodyContact> group = contacts_within(reach, time);
        const std::set<int> members = nearest_bodies(found, group);
        std::erase_if(group, [&](const BodyContact& other) {
            const auto is_outside = [&](int number) {
                return is_movable(number) && !members.contains(number);
            };
            return is_outside(other.contact.first) || is_outside(other.contact.second);
        });
        if (!bring_in(group, time)) {
            return group;
        }
    }
}

/// The bodies of a contact that move, and those that touch them directly or through others: all
/// that are as near as the others or nearer, up to kMaxBodies, so that an impact in a long row
/// costs no more than what it reaches. Those farther away are hit afterwards.
std::set<int> RestitutionPass::nearest_bodies(const BodyContact& found,
                                              const std::vector<BodyContact>& contacts) const {
    constexpr std::size_t kMaxBodies = 12;
    std::set<int> members;
    std::set<int> next{found.contact.first, found.contact.second};
    std::erase_if(next, [this](int number) { return !is_movable(number); });
    while (!next.empty() && (members.empty() || members.size() + next.size() <= kMaxBodies)) {
        members.insert(next.begin(), next.end());
        next.clear();
        for (const BodyContact& other : contacts) {
            for (const auto& [number, partner] :
                 {std::pair(other.contact.first, other.contact.second),
                  std::pair(other.contact.second, other.contact.first)}) {
                if (members.contains(number) && is_movable(partner) && !members.contains(partner)) {
                    next.insert(partner);
                }
            }
        }
    }
    return members;
}

/// The contacts of bodies in the solver, with those of wider gaps where a pair has none. Balls in
/// closed form may be partners.
std::vector<BodyContact> RestitutionPass::contacts_within(double reach, double time) {
    std::vector<Placement> placed = placements_of(bodies_.all());
    for (std::size_t i = 0; i < placed.size(); ++i) {
        if (placed[i].mode == Mode::closed_form) {
            placed[i] = {bodies_.all()[i].segment.state_at(time), Mode::asleep};
        }
    }
    std::vector<BodyContact> contacts = finder_.find(bodies_.all(), placed);
    std::set<ContactPair> touching;
    for (const BodyContact& found : contacts) {
        touching.insert(found.pair());
    }
    for (const BodyContact& found : finder_.find_within(reach, bodies_.all(), placed)) {
        if (!touching.contains(found.pair())) {
            contacts.push_back(found);
        }
    }
    std::erase_if(contacts, [this](const BodyContact& found) {
        return is_jammed(found) || is_on_lining(found);
    });
    return contacts;
}

/// Wakes the sleeping bodies of the group and puts its balls in closed form into the solver; true
/// if there were any.
bool RestitutionPass::bring_in(const std::vector<BodyContact>& group, double time) {
    bool has_news = false;
    for (const BodyContact& found : group) {
        for (const int number : {found.contact.first, found.contact.second}) {
            if (!is_movable(number) || body(number).is_in_solver()) {
                continue;
            }
            const auto index = static_cast<std::uint32_t>(number);
            if (body(number).is_asleep()) {
                bodies_.wake(index, time);
            } else {
                bodies_.enter_solver(index, time);
                body(number).state = body(number).segment.state;
                body(number).free_steps = 0;
            }
            has_news = true;
        }
    }
    return has_news;
}

bool RestitutionPass::is_movable(int number) const {
    return number >= 0 && !bodies_.all()[static_cast<std::size_t>(number)].is_kinematic();
}

bool RestitutionPass::is_on_lining(const BodyContact& found) const {
    return !found.is_between_bodies() &&
           bodies_.all()[static_cast<std::size_t>(found.contact.first)].is_ball() &&
           is_lining(finder_.info(found.partner).material, found.contact.normal);
}

/// How far the bodies of a group may come while the two compress each other, m.
double RestitutionPass::reach_of(const BodyContact& found, double speed) {
    double inverse_mass = 0;
    for (const int number : {found.contact.first, found.contact.second}) {
        inverse_mass += is_movable(number) ? 1 / body(number).mass : 0;
    }
    const double duration = contact_time(stiffness_of(found), 1 / inverse_mass, speed);
    return std::min(kSolidMargin + 2 * speed * duration, kMaxReach);
}

/// Hertz' law for what is round, the flat law for all else.
ContactStiffness RestitutionPass::stiffness_of(const BodyContact& found) {
    double curvature = 0;
    const auto add_radius = [&](double radius) { curvature += radius > 0 ? 1 / radius : 0; };
    add_radius(body(found.contact.first).radius);
    if (found.is_between_bodies()) {
        add_radius(body(found.contact.second).radius);
    } else if (const auto* sphere = std::get_if<StaticSphere>(&found.partner)) {
        add_radius(environment_.spheres[sphere->index].radius);
    }
    return curvature > 0 ? ball_stiffness(1 / curvature) : kFlatStiffness;
}

GroupBody RestitutionPass::group_body_of(int number) {
    if (is_movable(number)) {
        return group_body(body(number));
    }
    GroupBody fixed;
    if (number >= 0) {
        fixed.velocity = body(number).state.velocity;
        fixed.angular_velocity = body(number).state.angular_velocity;
    }
    return fixed;
}

/// Flat sides are taken to touch at gaps up to kSolidMargin, so that a face lands as a face: no
/// surface is flatter than that, and rounding would let one corner hit first and turn the body.
GroupContact RestitutionPass::group_contact(const BodyContact& found) {
    const ode::StepContact& from = found.contact;
    const MovingBody& first = body(from.first);
    GroupContact contact;
    contact.normal = from.normal;
    contact.first_arm =
        first.is_ball() ? from.normal * -first.radius : from.point - first.state.position;
    contact.gap = std::max(-from.depth - (first.is_ball() ? kPolish : kSolidMargin), 0.0);
    contact.stiffness = stiffness_of(found);
    contact.restitution = from.restitution;
    contact.friction = from.friction;
    if (found.is_between_bodies()) {
        const MovingBody& second = body(from.second);
        contact.second_arm = from.point - second.state.position;
        contact.are_spheres = first.is_ball() && second.is_ball();
        if (contact.are_spheres) {
            contact.friction = touching_pair(environment_, first, second, from.normal).friction;
        }
    }
    return contact;
}

/// False, without effect, if the impact has no end, or if a ball has met one thing alone.
bool RestitutionPass::bounce_group(const std::vector<BodyContact>& group, double time) {
    std::vector<GroupBody> bodies;
    std::map<int, std::size_t> places;  // in `bodies`; -1 is the static environment
    const auto place_of = [&](int number) {
        const auto [place, is_new] = places.try_emplace(number, bodies.size());
        if (is_new) {
            bodies.push_back(group_body_of(number));
        }
        return place->second;
    };
    std::vector<GroupContact> contacts;
    for (const BodyContact& found : group) {
        contacts.push_back(group_contact(found));
        contacts.back().first = place_of(found.contact.first);
        contacts.back().second = place_of(found.contact.second);
    }
    const std::vector<GroupContactResult> results =
        group_impact(bodies, contacts, environment_.law.ball_ball, kPrecision);
    std::size_t touched = 0;
    bool is_of_balls = true;
    for (std::size_t i = 0; i < results.size(); ++i) {
        touched += results[i].touched_after ? 1 : 0;
        is_of_balls &= !results[i].touched_after || body(group[i].contact.first).is_ball();
    }
    if (touched == 0 || (touched == 1 && is_of_balls)) {
        return false;
    }
    for (const auto& [number, place] : places) {
        const GroupBody& after = bodies[place];
        if (is_movable(number) && (after.velocity != body(number).state.velocity ||
                                   after.angular_velocity != body(number).state.angular_velocity)) {
            set_velocities(body(number), {after.velocity, after.angular_velocity}, time);
        }
    }
    log_group(group, results);
    return true;
}

/// Contacts that close more slowly than bodies bounce are no impacts.
void RestitutionPass::log_group(const std::vector<BodyContact>& group,
                                const std::vector<GroupContactResult>& results) {
    std::map<ContactPair, double> approach;
    for (std::size_t i = 0; i < group.size(); ++i) {
        double& most = approach[group[i].pair()];
        most = std::max(most, results[i].approach);
    }
    for (std::size_t i = 0; i < group.size(); ++i) {
        if (results[i].impulse.normal > 0 && approach[group[i].pair()] > kBounceSpeed) {
            add_to_log(group[i], results[i].impulse);
        }
    }
}

void RestitutionPass::add_to_log(const BodyContact& found, const ImpulsePair& impulse) {
    const auto same = std::find_if(
        impacts_.begin(), impacts_.end(),
        [&](const LoggedImpact& impact) { return impact.contact.pair() == found.pair(); });
    if (same == impacts_.end()) {
        impacts_.push_back({found, impulse});
    } else {
        same->impulse.normal += impulse.normal;
        same->impulse.tangential += impulse.tangential;
    }
}

void RestitutionPass::log_impacts(double time) {
    for (const LoggedImpact& impact : impacts_) {
        const ode::StepContact& contact = impact.contact.contact;
        recorder_.log_impact(time, body(contact.first).name(),
                             finder_.name_of(impact.contact.partner, bodies_.all()), contact.point,
                             contact.normal, impact.impulse);
    }
    impacts_.clear();
}

void RestitutionPass::set_velocities(MovingBody& body, const Velocities& velocities, double time) {
    if (body.is_kinematic()) {
        return;
    }
    const MotionState before = body.state;
    body.set(velocities);
    recorder_.add_break(body.track, time, body.with_own_axes(before),
                        body.with_own_axes(body.state));
}

}  // namespace carom::sim
