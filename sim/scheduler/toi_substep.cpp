#include "sim/scheduler/toi_substep.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "core/rigid.h"
#include "sim/motion/free_rotation.h"
#include "sim/numeric/tolerances.h"

namespace carom::sim {
namespace {

/// Lasting contacts may get deeper by this much (m) in the first half of a step; those of cylinder
/// rims, whose contact points move fastest, by less. Otherwise the step is halved, up to so
/// many times.
constexpr double kMaxSinking = 3e-6;
constexpr double kMaxRimSinking = 1e-6;
constexpr int kMaxHalvings = 5;
/// No step is made shorter than this (s) because of an impact.
constexpr double kShortestStep = 1e-5;

}  // namespace

void ToiSubstep::attempt(double start, double end,
                         const std::vector<BodyContact>& contacts_at_start) {
    start_ = start;
    end_ = end;
    placed_ = placements_of(bodies_);
    collect_contacts_at_start(contacts_at_start);
    collect_moving();
    advance_to_midpoint();
    for (int i = 0; i < kMaxHalvings && relative_sinking() > 1; ++i) {
        end_ = start + 0.5 * (end_ - start);
        advance_to_midpoint();
    }
    solve();
    const double whole = end_ - start;
    const double fraction = fraction_until_contact();
    if (fraction < 1) {
        end_ = start + std::max(fraction * whole, std::min(kShortestStep, whole));
        advance_to_midpoint();
        solve();
    }
}

/// The depth by which lasting contacts sink in the first half of the step, as a fraction of the
/// limit: a body that rolls on a rim or a corner turns away from its previous contact.
double ToiSubstep::relative_sinking() const {
    const auto has_rim = [this](int number) {
        if (number < 0) {
            return false;
        }
        const MovingBody& body = bodies_[static_cast<std::size_t>(number)];
        return !body.is_ball() && body.shape->kind() == ConvexShape::Kind::cylinder;
    };
    double most = 0;
    for (const BodyContact& found : contacts_) {
        if (found.contact.depth <= 0 || bounces_.is_jammed(found)) {
            continue;
        }
        const double sunk = approach(found) * 0.5 * (end_ - start_);
        const bool is_rim = has_rim(found.contact.first) || has_rim(found.contact.second);
        most = std::max(most, sunk / (is_rim ? kMaxRimSinking : kMaxSinking));
    }
    return most;
}

double ToiSubstep::approach(const BodyContact& found) const {
    return -relative_velocity(found).dot(found.contact.normal);
}

bool ToiSubstep::shorten(double end) {
    if (end < end_ && end > start_) {
        end_ = end;
        advance_to_midpoint();
        solve();
    }
    return end > start_;
}

void ToiSubstep::collect_moving() {
    moving_.clear();
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        if (bodies_[i].is_in_solver()) {
            moving_.push_back(static_cast<int>(i));
        }
    }
}

void ToiSubstep::advance_to_midpoint() {
    midpoint_states_.clear();
    for (const int number : moving_) {
        const MovingBody& body = bodies_[static_cast<std::size_t>(number)];
        const double half = 0.5 * (end_ - start_);
        MotionState& state = placed_[static_cast<std::size_t>(number)].state;
        state = body.is_kinematic() ? body.path->at(start_ + half)
                                    : drift(body.state, body.inertia, half);
        midpoint_states_.push_back(state);
    }
    contacts_ = finder_.find(bodies_, placed_);
    drop_impacts();
    drop_immovable_pairs();
    step_contacts_.clear();
    for (BodyContact& found : contacts_) {
        found.contact.turning = turning(found);
        step_contacts_.push_back(found.contact);
    }
}

void ToiSubstep::solve() {
    world_.step({end_ - start_, gravity_, moving_, midpoint_states_, step_contacts_}, motions_,
                impulses_);
    for (std::size_t slot = 0; slot < moving_.size(); ++slot) {
        const MovingBody& body = bodies_[static_cast<std::size_t>(moving_[slot])];
        if (body.is_kinematic()) {
            motions_[slot].end = body.path->at(end_);
        }
    }
}

void ToiSubstep::collect_contacts_at_start(const std::vector<BodyContact>& contacts) {
    contacts_at_start_.clear();
    for (const BodyContact& found : contacts) {
        const Vec3 arm = found.contact.point - state_of(found.contact.first).position;
        contacts_at_start_.emplace(
            found.pair(), ContactAtStart{arm, relative_velocity(found), found.contact.normal});
    }
}

/// The velocity (m/s) of the first body relative to the second.
Vec3 ToiSubstep::relative_velocity(const BodyContact& found) const {
    const Vec3& point = found.contact.point;
    const Vec3 first = velocity_at(state_of(found.contact.first), point);
    return found.is_between_bodies() ? first - velocity_at(state_of(found.contact.second), point)
                                     : first;
}

/// StepContact::turning: what the relative velocity has gained along the normal, which turns, and
/// across it, since the start, when the nearest contact of the pair was this one. Only a part of
/// the velocity at the midpoint is reversed without work, so this is one: where the contact slips
/// or opens at the start it would gain energy otherwise. It opens at the start if the turn was
/// faster in the second half of the last step than in the first; then all of its opening is
/// reversed.
Vec3 ToiSubstep::turning(const BodyContact& found) const {
    const Vec3 arm = found.contact.point - state_of(found.contact.first).position;
    const Vec3& normal = found.contact.normal;
    const ContactAtStart* nearest = nullptr;
    double least = std::numeric_limits<double>::infinity();
    const auto [begin, end] = contacts_at_start_.equal_range(found.pair());
    for (auto start = begin; start != end; ++start) {
        const Vec3 d = start->second.arm - arm;
        if (d.dot(d) < least) {
            least = d.dot(d);
            nearest = &start->second;
        }
    }
    if (nearest == nullptr) {
        return {0, 0, 0};
    }
    const Vec3 velocity = relative_velocity(found);
    const double speed = velocity.dot(normal);
    const double opening = speed - nearest->velocity.dot(nearest->normal);
    const Vec3 slip = across(velocity, normal);
    const Vec3 gained = slip - across(nearest->velocity, nearest->normal);
    const double square = slip.dot(slip);
    const double share = square > 0 ? std::clamp(gained.dot(slip) / square, 0.0, 1.0) : 0;
    const double reversed = opening > 0 ? std::clamp(speed, opening, 2 * opening)
                                        : std::max(opening, std::min(speed, 0.0));
    return slip * share + normal * reversed;
}

/// At the midpoint: a contact that was open at the start and closes fast is an impact, not a
/// lasting contact. Contacts of a pair that close at similar speeds are classified together, so
/// that rounding cannot split them and turn the bodies.
void ToiSubstep::drop_impacts() {
    std::map<ContactPair, double> fastest;
    std::vector<double> speeds;
    for (const BodyContact& found : contacts_) {
        const double speed = bounces_.is_jammed(found) ? 0 : approach(found);
        const double gap_at_start = 0.5 * (end_ - start_) * speed - found.contact.depth;
        speeds.push_back(gap_at_start > kClosedGap ? speed : 0);
        double& most = fastest[found.pair()];
        most = std::max(most, speeds.back());
    }
    std::size_t kept = 0;
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        const double most = fastest[contacts_[i].pair()];
        if (most <= kBounceSpeed || speeds[i] < 0.5 * most) {
            contacts_[kept++] = contacts_[i];
        }
    }
    contacts_.resize(kept);
}

/// A contact between bodies that cannot move, kinematic or asleep, needs no solving.
void ToiSubstep::drop_immovable_pairs() {
    const auto can_move = [this](int number) {
        if (number < 0) {
            return false;
        }
        const auto i = static_cast<std::size_t>(number);
        return placed_[i].is_in_solver() && !bodies_[i].is_kinematic();
    };
    std::erase_if(contacts_, [&](const BodyContact& found) {
        return !can_move(found.contact.first) && !can_move(found.contact.second);
    });
}

/// State of the body of that slot, `time` after the step's start.
MotionState ToiSubstep::state_after(std::size_t slot, double time) const {
    const MovingBody& body = bodies_[static_cast<std::size_t>(moving_[slot])];
    const double half = 0.5 * (end_ - start_);
    if (body.is_kinematic()) {
        return body.path->at(start_ + time);
    }
    return time < half ? drift(body.state, body.inertia, time)
                       : drift(motions_[slot].after, body.inertia, time - half);
}

void ToiSubstep::move_to(double fraction) {
    const double time = fraction * (end_ - start_);
    for (std::size_t slot = 0; slot < moving_.size(); ++slot) {
        placed_[static_cast<std::size_t>(moving_[slot])].state = state_after(slot, time);
    }
}

/// The fraction of the step that passes before the first impact or new contact.
double ToiSubstep::fraction_until_contact() {
    std::set<ContactPair> known;
    for (const BodyContact& found : contacts_) {
        known.insert(found.pair());
    }
    const auto deepest_at = [&](double fraction) {
        move_to(fraction);
        double deepest = 0;
        for (const BodyContact& found : finder_.find(bodies_, placed_)) {
            if (found.contact.depth > deepest && !bounces_.is_jammed(found) &&
                (!known.contains(found.pair()) || approach(found) > kBounceSpeed)) {
                deepest = found.contact.depth;
            }
        }
        return deepest;
    };
    if (deepest_at(1) <= kContactDepth) {
        return 1;
    }
    double low = 0;
    double high = 1;
    for (int i = 0; i < 16; ++i) {
        const double middle = 0.5 * (low + high);
        const double depth = deepest_at(middle);
        if (depth > 0.25 * kContactDepth && depth <= kContactDepth) {
            return middle;
        }
        (depth > kContactDepth ? high : low) = middle;
    }
    return low;
}

}  // namespace carom::sim
