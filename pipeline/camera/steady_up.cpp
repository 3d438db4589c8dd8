#include "pipeline/camera/steady_up.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "core/elementary.h"
#include "core/error.h"
#include "pipeline/camera/changing_value.h"
#include "pipeline/camera/path_fit.h"
#include "pipeline/camera/view_walk.h"

namespace carom::pipeline {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kFastTurn = kPi / 3;      // rad, within ...
constexpr double kFastTime = 1.0 / 24;     // ... s of the film as it was written
constexpr double kSlowRate = 4 * kPi / 3;  // rad/s, 10 degrees in that time: for the rest
constexpr double kSmallestSine = 1e-6;     // between view and `up`, as in camera_state

bool is_fixed(const CameraPath& path) {
    const auto* bezier = std::get_if<BezierPath>(&path);
    return bezier != nullptr && bezier->points.size() == 1;
}

/// Indices of nodes, first < last.
struct Part {
    std::size_t first = 0, last = 0;
};

/// Finds the parts of a walked path on which the up direction is carried.
class TurnFinder {
  public:
    TurnFinder(std::vector<ViewNode> nodes, double length)
        : nodes_(std::move(nodes)), length_(length), twist_(nodes_.size()) {
        add_up_twist();
    }

    std::vector<UpTurn> run() {
        std::vector<Part> parts = merged(fast_parts());
        for (Part& part : parts) {
            widen(part);
        }
        std::vector<UpTurn> turns;
        bool is_over = false;
        for (const Part& part : merged(std::move(parts))) {
            if (std::optional<UpTurn> turn = turn_of(part, is_over)) {
                is_over = turn->is_over;
                turns.push_back(std::move(*turn));
            }
        }
        return turns;
    }

  private:
    [[nodiscard]] double time(std::size_t node) const { return nodes_[node].done * length_; }

    /// The up direction of a node that has none is the one before, carried.
    [[nodiscard]] Vec3 carried_to(std::size_t node, const Vec3& upright) const {
        return carried(upright, nodes_[node - 1].ahead, nodes_[node].ahead);
    }

    /// Sums up how far the plain picture has turned against one that is carried along the path. It
    /// does not count turns at jumps of the view, nor those of `up` itself.
    void add_up_twist() {
        Vec3 upright(0, 0, 0);  // of the node before, plain if it has one
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            const ViewNode& node = nodes_[i];
            twist_[i] = i == 0 ? 0 : twist_[i - 1];
            const bool is_known = i > 0 && upright != Vec3(0, 0, 0);
            const bool is_counted = is_known && !node.is_after_jump;
            if (is_counted) {
                upright = carried_to(i, upright);
                const bool turns_itself = angle_between(nodes_[i - 1].up, node.up) >
                                          angle_between(nodes_[i - 1].ahead, node.ahead);
                if (has_upright(node) && !turns_itself) {
                    twist_[i] += turn_about(node.ahead, upright, node.upright);
                }
            }
            if (has_upright(node) || !is_counted) {
                upright = node.upright;
            }
        }
    }

    /// The shortest parts that turn fast, and those around nodes without an up direction.
    [[nodiscard]] std::vector<Part> fast_parts() const {
        std::vector<Part> parts;
        for (std::size_t last = 1; last < nodes_.size(); ++last) {
            for (std::size_t first = last; first-- > 0;) {
                if (time(last) - time(first) > kFastTime || nodes_[first + 1].is_after_jump) {
                    break;
                }
                if (std::abs(twist_[last] - twist_[first]) > kFastTurn) {
                    const bool is_inside = parts.empty() || parts.back().first < first;
                    if (is_inside) {
                        parts.push_back({first, last});
                    }
                    break;
                }
            }
        }
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            if (!has_upright(nodes_[i])) {
                const Part part{i - (can_begin_before(i) ? 1 : 0), i + (can_end_after(i) ? 1 : 0)};
                if (part.first < part.last) {
                    parts.push_back(part);
                }
            }
        }
        return parts;
    }

    [[nodiscard]] bool can_begin_before(std::size_t node) const {
        return node > 0 && !nodes_[node].is_after_jump;
    }
    [[nodiscard]] bool can_end_after(std::size_t node) const {
        return node + 1 < nodes_.size() && !nodes_[node + 1].is_after_jump;
    }

    /// Parts that overlap become one.
    static std::vector<Part> merged(std::vector<Part> parts) {
        std::ranges::sort(parts, {}, &Part::first);
        std::vector<Part> result;
        for (const Part& part : parts) {
            if (!result.empty() && part.first < result.back().last) {
                result.back().last = std::max(result.back().last, part.last);
            } else {
                result.push_back(part);
            }
        }
        return result;
    }

    [[nodiscard]] double twist_of(const Part& part) const {
        return twist_[part.last] - twist_[part.first];
    }

    /// What remains of the turn beyond whole half turns, in [-pi / 2, pi / 2].
    [[nodiscard]] double rest_of(const Part& part) const {
        return twist_of(part) - kPi * std::round(twist_of(part) / kPi);
    }

    /// Lets the part begin earlier and end later until what remains is made up for slowly.
    void widen(Part& part) const {
        const auto is_too_fast = [&] {
            return std::abs(rest_of(part)) > kSlowRate * (time(part.last) - time(part.first));
        };
        while (is_too_fast() && (can_begin_before(part.first) || can_end_after(part.last))) {
            const bool is_start_nearer =
                can_begin_before(part.first) &&
                (!can_end_after(part.last) ||
                 time(part.last + 1) - time(part.last) >= time(part.first) - time(part.first - 1));
            part.first -= is_start_nearer ? 1 : 0;
            part.last += is_start_nearer ? 0 : 1;
        }
    }

    /// Empty if the view is along `up` on the whole part.
    [[nodiscard]] std::optional<UpTurn> turn_of(const Part& part, bool is_over) const {
        UpTurn turn;
        for (std::size_t i = part.first; i <= part.last; ++i) {
            turn.keys.push_back({nodes_[i].done, nodes_[i].ahead, Vec3(0, 0, 0)});
        }
        const ViewNode& first = nodes_[part.first];
        const ViewNode& last = nodes_[part.last];
        turn.is_over = is_over;
        if (has_upright(first)) {
            carry_forward(turn, part, is_over ? -first.upright : first.upright);
            if (has_upright(last)) {
                turn.roll = rest_of(part);
                turn.is_over = is_over != (std::lround(twist_of(part) / kPi) % 2 != 0);
            }
        } else if (has_upright(last)) {
            carry_backward(turn, is_over ? -last.upright : last.upright);
        } else {
            return std::nullopt;
        }
        return turn;
    }

    void carry_forward(UpTurn& turn, const Part& part, const Vec3& start) const {
        turn.keys.front().upright = start;
        for (std::size_t i = 1; i < turn.keys.size(); ++i) {
            turn.keys[i].upright = carried_to(part.first + i, turn.keys[i - 1].upright);
        }
    }

    static void carry_backward(UpTurn& turn, const Vec3& end) {
        turn.keys.back().upright = end;
        for (std::size_t i = turn.keys.size() - 1; i > 0; --i) {
            turn.keys[i - 1].upright =
                carried(turn.keys[i].upright, turn.keys[i].ahead, turn.keys[i - 1].ahead);
        }
    }

    std::vector<ViewNode> nodes_;
    double length_;
    std::vector<double> twist_;  // rad, up to each node
};

}  // namespace

Vec3 upright_of(const Vec3& ahead, const Vec3& up) {
    const Vec3 level = ahead.cross(up.normalized());
    return level.length() > kSmallestSine ? level.normalized().cross(ahead) : Vec3(0, 0, 0);
}

Vec3 carried(const Vec3& upright, const Vec3& from, const Vec3& to) {
    const double cosine = from.dot(to);
    if (cosine < -1 + 1e-12) {  // every axis is as good
        return upright;
    }
    const Vec3 turned = upright - to.dot(upright) / (1 + cosine) * (from + to);
    return (turned - to.dot(turned) * to).normalized();
}

double turn_about(const Vec3& axis, const Vec3& a, const Vec3& b) {
    return arctangent2(axis.dot(a.cross(b)), a.dot(b));
}

std::vector<UpTurn> find_up_turns(const CameraRig& rig, const sim::Timeline& timeline) {
    const bool is_still = is_fixed(rig.position) && is_fixed(rig.target);
    if (is_still || rig.path_start == rig.path_end) {
        return {};
    }
    CameraRig fitted = rig;
    for (CameraPath* path : {&fitted.position, &fitted.target}) {
        if (const auto* along = std::get_if<AlongPath>(path)) {
            *path = fit_bezier_path(*along, timeline);
        }
    }
    const FilmInterval whole = written_interval(rig);
    return TurnFinder(views_along(fitted, timeline), (whole.end - whole.start).to_double()).run();
}

void keep_up(std::span<CameraRig> rigs, const sim::Timeline& timeline) {
    for (CameraRig& rig : rigs) {
        try {
            if (!rig.up_turns) {
                rig.up_turns = find_up_turns(rig, timeline);
            }
        } catch (const Error&) {  // the object's absence is reported for each frame
            continue;
        }
    }
}

Vec3 steady_up(std::span<const UpTurn> turns, double done, const Vec3& ahead, const Vec3& up) {
    const UpTurn* before = nullptr;
    for (const UpTurn& turn : turns) {
        const double from = turn.keys.front().done;
        const double to = turn.keys.back().done;
        const bool is_begun = from <= done || from <= 0;
        if (is_begun && (done <= to || to >= 1)) {
            const auto next = std::ranges::upper_bound(turn.keys, done, {}, &UprightKey::done);
            const UprightKey& key = next == turn.keys.begin() ? *next : *(next - 1);
            const Vec3 upright = carried(key.upright, key.ahead, ahead);
            const double share = from < to ? std::clamp((done - from) / (to - from), 0.0, 1.0) : 1;
            const SinCos roll = sin_cos(share * turn.roll);
            return roll.cos * upright + roll.sin * ahead.cross(upright);
        }
        before = is_begun ? &turn : before;
    }
    if (before == nullptr || !before->is_over) {
        return up;
    }
    const Vec3 upright = upright_of(ahead, up);
    return upright == Vec3(0, 0, 0) ? up : -upright;
}

}  // namespace carom::pipeline
