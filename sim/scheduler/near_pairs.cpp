#include "sim/scheduler/near_pairs.h"

#include <algorithm>
#include <functional>

#include "core/length.h"

namespace carom::sim {
namespace {

/// A list holds until a body has moved by kSlack (m) and as far as its velocity leads in
/// kSlackTime (s), eight steps of ODE. Longer lists have more pairs, shorter ones are made more
/// often.
constexpr double kSlack = 1e-3;
constexpr double kSlackTime = 1.0 / 120;

bool is_collidable(const Placement& placed) {
    return placed.is_in_solver() || placed.mode == Mode::asleep;
}

Aabb box_of(const Vec3& centre, double radius) {
    Aabb box{centre, centre};
    box.grow(radius);
    return box;
}

}  // namespace

bool NearPairs::Member::contains(const Vec3& place) const {
    const Vec3 moved = place - centre;
    return moved.dot(moved) <= slack * slack;
}

/// Takes over the bodies, and makes a new tree, unless they are those of the last call and are
/// still near their places.
void NearPairs::Group::update(std::vector<Member> members, std::span<const MovingBody> bodies) {
    const auto is_kept = [](const Member& known, const Member& now) {
        return known.number == now.number && known.contains(now.centre);
    };
    if (std::ranges::equal(members_, members, is_kept)) {
        return;
    }
    members_ = std::move(members);
    std::vector<Aabb> boxes;
    boxes.reserve(members_.size());
    for (const Member& member : members_) {
        boxes.push_back(
            box_of(member.centre, bodies[member.number].bounding_radius() + member.slack));
    }
    tree_ = AabbTree(boxes);
}

bool NearPairs::holds(std::span<const Placement> placed) const {
    return std::ranges::equal(known_, placed, [](const Member& known, const Placement& now) {
        return is_collidable(now) ? (now.is_in_solver() ? known.slack > 0 : known.slack == 0) &&
                                        known.contains(now.state.position)
                                  : known.slack < 0;
    });
}

void NearPairs::add_pairs(const Member& member, const Aabb& box) {
    for (const Group& group : groups_) {
        group.tree().query(box, found_);
        for (const std::uint32_t index : found_) {
            const auto [low, high] = std::minmax(member.number, group.members()[index].number);
            pairs_.emplace_back(low, high);
        }
    }
}

const std::vector<NearPairs::Pair>& NearPairs::find(std::span<const MovingBody> bodies,
                                                    std::span<const Placement> placed) {
    if (holds(placed)) {
        return pairs_;
    }
    in_solver_.clear();
    std::array<std::vector<Member>, 3> members;
    for (std::uint32_t i = 0; i < placed.size(); ++i) {
        const MotionState& state = placed[i].state;
        if (placed[i].is_in_solver()) {
            in_solver_.push_back(i);
            const double reach = kSlackTime * length(state.velocity);
            members[reach < kSlack ? 1 : 2].push_back({i, state.position, kSlack + reach});
        } else if (is_collidable(placed[i])) {
            members[0].push_back({i, state.position, 0});
        }
    }
    known_.assign(placed.size(), {});
    for (std::size_t i = 0; i < groups_.size(); ++i) {
        groups_[i].update(std::move(members[i]), bodies);
        for (const Member& member : groups_[i].members()) {
            known_[member.number] = member;
        }
    }
    pairs_.clear();
    for (const Group& group : {std::cref(groups_[1]), std::cref(groups_[2])}) {
        for (const Member& member : group.members()) {
            const double reach = bodies[member.number].bounding_radius() + member.slack;
            add_pairs(member, box_of(member.centre, reach + gap_));
        }
    }
    // Each pair of two in the solver has been found twice, and each body with itself.
    std::erase_if(pairs_, [](const Pair& pair) { return pair.first == pair.second; });
    std::sort(pairs_.begin(), pairs_.end());
    pairs_.erase(std::unique(pairs_.begin(), pairs_.end()), pairs_.end());
    return pairs_;
}

}  // namespace carom::sim
