#include "sim/scheduler/near_pairs.h"

#include <algorithm>

#include "core/length.h"

namespace carom::sim {
namespace {

/// A list holds until a body has moved by kSlack (m) and as far as its velocity leads in
/// kSlackTime (s), four steps of ODE. Longer lists have more pairs, shorter ones are made more
/// often.
constexpr double kSlack = 1e-3;
constexpr double kSlackTime = 1.0 / 240;

bool is_collidable(const Placement& placed) {
    return placed.is_in_solver() || placed.mode == Mode::asleep;
}

Aabb box_of(const Vec3& centre, double radius) {
    Aabb box{centre, centre};
    box.grow(radius);
    return box;
}

}  // namespace

/// Takes over the bodies, and makes a new tree if they are not those of the last call.
void NearPairs::Group::update(std::vector<Member> members, std::span<const MovingBody> bodies) {
    if (members == members_) {
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

bool NearPairs::Group::holds(std::span<const Placement> placed) const {
    return std::ranges::all_of(members_, [&](const Member& member) {
        const Placement& now = placed[member.number];
        const Vec3 moved = now.state.position - member.centre;
        return is_collidable(now) && now.is_in_solver() == (member.slack > 0) &&
               moved.dot(moved) <= member.slack * member.slack;
    });
}

void NearPairs::add_pairs(const Member& member, const Aabb& box, const Group& group) {
    group.tree().query(box, found_);
    for (const std::uint32_t index : found_) {
        const auto [low, high] = std::minmax(member.number, group.members()[index].number);
        pairs_.emplace_back(low, high);
    }
}

const std::vector<NearPairs::Pair>& NearPairs::find(std::span<const MovingBody> bodies,
                                                    std::span<const Placement> placed) {
    const auto count = static_cast<std::size_t>(std::ranges::count_if(placed, is_collidable));
    if (count == count_ && awake_.holds(placed) && asleep_.holds(placed)) {
        return pairs_;
    }
    count_ = count;
    std::vector<Member> awake;
    std::vector<Member> asleep;
    for (std::uint32_t i = 0; i < placed.size(); ++i) {
        const MotionState& state = placed[i].state;
        if (placed[i].is_in_solver()) {
            awake.push_back({i, state.position, kSlack + kSlackTime * length(state.velocity)});
        } else if (is_collidable(placed[i])) {
            asleep.push_back({i, state.position, 0});
        }
    }
    awake_.update(std::move(awake), bodies);
    asleep_.update(std::move(asleep), bodies);
    pairs_.clear();
    for (const Member& member : awake_.members()) {
        const double reach = bodies[member.number].bounding_radius() + member.slack + gap_;
        const Aabb box = box_of(member.centre, reach);
        add_pairs(member, box, awake_);
        add_pairs(member, box, asleep_);
    }
    // Each pair of two in the solver has been found twice, and each body with itself.
    std::erase_if(pairs_, [](const Pair& pair) { return pair.first == pair.second; });
    std::sort(pairs_.begin(), pairs_.end());
    pairs_.erase(std::unique(pairs_.begin(), pairs_.end()), pairs_.end());
    return pairs_;
}

}  // namespace carom::sim
