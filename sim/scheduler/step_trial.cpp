#include "sim/scheduler/step_trial.h"

#include <algorithm>
#include <map>
#include <utility>

namespace carom::sim {
namespace {

/// Bodies that were apart may overlap by this much (m) at a step's end; else the step is shortened
/// to when they met.
constexpr double kTouchDepth = 5e-6;
/// No step is made shorter than this (s) for that reason.
constexpr double kShortestStep = 1e-5;

}  // namespace

StepTrial::StepTrial(const ContactFinder& finder, const Vec3& gravity,
                     const std::vector<StepBody>& bodies)
    : finder_(finder), gravity_(gravity), bodies_(bodies) {
    for (const StepBody& body : bodies)
        world_.add({body.mass, body.inertia});
}

void StepTrial::attempt(double start, double end, std::vector<FoundContact> contacts) {
    start_ = start;
    end_ = end;
    contacts_ = std::move(contacts);
    choose_moving();
    solve();
    const double whole = end - start;
    const double share = share_until_touch();
    if (share < 1) {
        end_ = start + std::max(share * whole, std::min(kShortestStep, whole));
        solve();
    }
}

bool StepTrial::shorten(double end) {
    if (end < end_ && end > start_) {
        end_ = end;
        solve();
    }
    return end > start_;
}

void StepTrial::choose_moving() {
    moving_.clear();
    states_.clear();
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        if (!bodies_[i].is_in || !bodies_[i].is_awake)
            continue;
        moving_.push_back(static_cast<int>(i));
        states_.push_back(bodies_[i].state);
    }
    step_contacts_.clear();
    for (const FoundContact& found : contacts_)
        step_contacts_.push_back(found.contact);
}

void StepTrial::solve() {
    world_.step(end_ - start_, gravity_, moving_, states_, step_contacts_, motions_, impulses_);
}

/// Which share of the step passes before bodies that were apart overlap.
double StepTrial::share_until_touch() const {
    std::map<std::pair<int, int>, bool> known;
    for (const FoundContact& found : contacts_)
        known[found.pair()] = true;
    std::vector<StepBody> trial = bodies_;
    const auto overlaps_at = [&](double share) {
        for (std::size_t slot = 0; slot < moving_.size(); ++slot) {
            const ode::StepMotion& motion = motions_[slot];
            MotionState& state = trial[static_cast<std::size_t>(moving_[slot])].state;
            state.position =
                motion.before.position + (motion.end.position - motion.before.position) * share;
            state.orientation =
                Imath::slerpShortestArc(motion.before.orientation, motion.end.orientation, share);
        }
        for (const FoundContact& found : finder_.find(trial)) {
            if (found.contact.depth > kTouchDepth && !known.contains(found.pair()))
                return true;
        }
        return false;
    };
    if (!overlaps_at(1))
        return 1;
    double low = 0;
    double high = 1;
    for (int i = 0; i < 9; ++i) {
        const double middle = 0.5 * (low + high);
        (overlaps_at(middle) ? high : low) = middle;
    }
    return low;
}

}  // namespace carom::sim
