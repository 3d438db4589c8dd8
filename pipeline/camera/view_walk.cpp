#include "pipeline/camera/view_walk.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "core/elementary.h"
#include "pipeline/camera/camera_path.h"
#include "pipeline/camera/changing_value.h"
#include "pipeline/camera/steady_up.h"
#include "pipeline/camera/time_map.h"

namespace carom::pipeline {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kFirstStep = 1.0 / 24;      // s of the film as it was written
constexpr double kShortest = 1e-6;           // the same, of the intervals of the path
constexpr double kStep = kPi / 18;           // rad, largest turn of the view in an interval
constexpr double kNearStep = kPi / 360;      // the same where `up` may be between its ends
constexpr double kTwist = kPi / 36;          // rad, largest turn of the picture in an interval
constexpr double kJump = kPi / 36;           // rad, in the shortest interval: the view jumps
constexpr std::size_t kMostNodes = 100'000;  // of a path

/// The angle between the view and the axis of `up`.
double angle_from_axis(const ViewNode& node) {
    return arctangent2(node.ahead.cross(node.up).length(), std::abs(node.ahead.dot(node.up)));
}

bool follows_scene(const CameraPath& path) {
    const auto* orbit = std::get_if<OrbitPath>(&path);
    return std::holds_alternative<FollowPath>(path) ||
           (orbit != nullptr && std::holds_alternative<FollowPath>(orbit->around));
}

/// Divides a path into intervals that are short enough to see how the picture turns.
class PathWalk {
  public:
    PathWalk(const CameraRig& rig, const sim::Timeline& timeline)
        : rig_(rig),
          timeline_(timeline),
          needs_scene_time_(follows_scene(rig.position) || follows_scene(rig.target)) {
        const FilmInterval whole = written_interval(rig);
        length_ = (whole.end - whole.start).to_double();
    }

    std::vector<ViewNode> run() {
        constexpr int kFewest = 16;
        constexpr int kMost = 2048;
        const int count = std::clamp(static_cast<int>(length_ / kFirstStep), kFewest, kMost);
        std::optional<ViewNode> before = node_at(0);
        add(before);
        for (int i = 1; i <= count; ++i) {
            const std::optional<ViewNode> after = node_at(static_cast<double>(i) / count);
            if (before && after) {
                divide(*before, *after);
            }
            add(after);
            before = after;
        }
        add_views_along_axis();
        mark_jumps();
        return std::move(nodes_);
    }

  private:
    /// Empty where the camera is at its target.
    [[nodiscard]] std::optional<ViewNode> node_at(double done) const {
        constexpr double kNearest = 1e-9;  // m
        RigInstant instant{{done, 1 - done}, 0};
        if (needs_scene_time_) {
            const double from = rig_.path_start.to_double();
            const double to = rig_.path_end.to_double();
            const double start = rig_.video_start.to_double();
            const double end = rig_.video_end.to_double();
            const double time = start + (end - start) * (done - from) / (to - from);
            instant.scene_time = scene_time_at(rig_, Rational::nearest(time)).to_double();
        }
        const Vec3 axis = path_position(rig_.target, instant, timeline_) -
                          path_position(rig_.position, instant, timeline_);
        if (!(axis.length() > kNearest)) {
            return std::nullopt;
        }
        ViewNode node;
        node.done = done;
        node.ahead = axis.normalized();
        node.up = value_at(rig_.up, rig_, instant.progress).normalized();
        node.upright = upright_of(node.ahead, node.up);
        return node;
    }

    void add(const std::optional<ViewNode>& node) {
        if (node) {
            nodes_.push_back(*node);
        }
    }

    [[nodiscard]] bool is_short(const ViewNode& a, const ViewNode& b) const {
        return (b.done - a.done) * length_ <= kShortest || nodes_.size() >= kMostNodes;
    }

    [[nodiscard]] bool is_divided(const ViewNode& a, const ViewNode& b) const {
        if (is_short(a, b)) {
            return false;
        }
        if (has_upright(a) != has_upright(b)) {
            return true;
        }
        const double angle = angle_between(a.ahead, b.ahead);
        if (angle > kStep || !has_upright(a)) {
            return angle > kStep;
        }
        const bool may_pass_axis =
            angle > kNearStep && std::min(angle_from_axis(a), angle_from_axis(b)) < angle;
        const Vec3 plain = carried(a.upright, a.ahead, b.ahead);
        return may_pass_axis || std::abs(turn_about(b.ahead, plain, b.upright)) > kTwist;
    }

    /// Adds what is needed between two nodes.
    void divide(const ViewNode& a, const ViewNode& b) {
        if (!is_divided(a, b)) {
            return;
        }
        if (const std::optional<ViewNode> middle = node_at((a.done + b.done) / 2)) {
            divide(a, *middle);
            nodes_.push_back(*middle);
            divide(*middle, b);
        }
    }

    /// Adds the views that are nearest to the axis of `up`, which may be along it for an instant.
    void add_views_along_axis() {
        constexpr double kNear = kPi / 90;  // rad
        std::vector<ViewNode> nearest;
        for (std::size_t i = 1; i + 1 < nodes_.size(); ++i) {
            const double angle = angle_from_axis(nodes_[i]);
            const bool is_lowest =
                angle <= angle_from_axis(nodes_[i - 1]) && angle < angle_from_axis(nodes_[i + 1]);
            if (has_upright(nodes_[i]) && angle < kNear && is_lowest) {
                if (auto node = nearest_to_axis(nodes_[i - 1].done, nodes_[i + 1].done)) {
                    nearest.push_back(*node);
                }
            }
        }
        std::erase_if(nearest, [](const ViewNode& node) { return has_upright(node); });
        nodes_.insert(nodes_.end(), nearest.begin(), nearest.end());
        std::ranges::stable_sort(nodes_, {}, &ViewNode::done);
    }

    /// By a ternary search.
    [[nodiscard]] std::optional<ViewNode> nearest_to_axis(double low, double high) const {
        constexpr int kRounds = 60;
        for (int round = 0; round < kRounds; ++round) {
            std::optional<ViewNode> a = node_at((2 * low + high) / 3);
            const std::optional<ViewNode> b = node_at((low + 2 * high) / 3);
            if (!a || !b) {
                return std::nullopt;
            }
            if (!has_upright(*a)) {
                return a;
            }
            (angle_from_axis(*a) < angle_from_axis(*b) ? high : low) =
                angle_from_axis(*a) < angle_from_axis(*b) ? b->done : a->done;
        }
        return node_at((low + high) / 2);
    }

    void mark_jumps() {
        for (std::size_t i = 1; i < nodes_.size(); ++i) {
            const ViewNode& before = nodes_[i - 1];
            const bool is_short = (nodes_[i].done - before.done) * length_ <= kShortest;
            nodes_[i].is_after_jump =
                angle_between(before.ahead, nodes_[i].ahead) > (is_short ? kJump : 1.001 * kStep);
        }
    }

    const CameraRig& rig_;
    const sim::Timeline& timeline_;
    bool needs_scene_time_;
    double length_ = 0;  // s of the film as it was written
    std::vector<ViewNode> nodes_;
};

}  // namespace

double angle_between(const Vec3& a, const Vec3& b) {
    return arctangent2(a.cross(b).length(), a.dot(b));
}

std::vector<ViewNode> views_along(const CameraRig& rig, const sim::Timeline& timeline) {
    return PathWalk(rig, timeline).run();
}

}  // namespace carom::pipeline
