#include "pipeline/plan/motion_stretches.h"

#include <algorithm>
#include <cmath>

namespace carom::pipeline {

namespace {

constexpr double kRate = 240;        // looks per second
constexpr int kMostLooks = 2400;     // between two keys
constexpr double kAirHeight = 1e-3;  // m
constexpr double kSlip = 0.01;       // m/s, of the point that touches the cloth
constexpr double kStill = 1e-3;      // m/s

Motion motion_of(const MotionState& state, std::optional<double> radius) {
    if (state.velocity.length() < kStill) {
        return Motion::still;
    }
    if (!radius) {
        return Motion::moving;
    }
    if (std::abs(state.position.z - *radius) > kAirHeight) {
        return Motion::airborne;
    }
    // v + omega x (0, 0, -R)
    const Vec2 slip(state.velocity.x - state.angular_velocity.y * *radius,
                    state.velocity.y + state.angular_velocity.x * *radius);
    return slip.length() > kSlip ? Motion::sliding : Motion::rolling;
}

double distance_to_line(const Vec2& point, const Vec2& a, const Vec2& b) {
    const Vec2 along = b - a;
    const double squared = along.length2();
    const double t = squared > 0 ? std::clamp((point - a).dot(along) / squared, 0.0, 1.0) : 0;
    return (point - (a + t * along)).length();
}

// Ramer, "An iterative procedure for the polygonal approximation of plane curves", 1972; Douglas
// and Peucker 1973.
void keep_needed(const std::vector<Vec2>& points, std::size_t first, std::size_t last,
                 double tolerance, std::vector<bool>& kept) {
    std::vector<std::pair<std::size_t, std::size_t>> spans{{first, last}};
    while (!spans.empty()) {
        const auto [from, to] = spans.back();
        spans.pop_back();
        std::size_t farthest = from;
        double distance = tolerance;
        for (std::size_t i = from + 1; i < to; ++i) {
            const double d = distance_to_line(points[i], points[from], points[to]);
            if (d > distance) {
                distance = d;
                farthest = i;
            }
        }
        if (farthest != from) {
            kept[farthest] = true;
            spans.emplace_back(from, farthest);
            spans.emplace_back(farthest, to);
        }
    }
}

std::vector<Vec2> simplified(const std::vector<Vec2>& points, double tolerance) {
    std::vector<bool> kept(points.size(), false);
    kept.front() = kept.back() = true;
    keep_needed(points, 0, points.size() - 1, tolerance, kept);
    std::vector<Vec2> result;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (kept[i]) {
            result.push_back(points[i]);
        }
    }
    return result;
}

Vec2 from_above(const Vec3& place) {
    return {place.x, place.y};
}

}  // namespace

std::vector<MotionStretch> motion_stretches(const sim::Track& track, std::optional<double> radius,
                                            double end, double tolerance) {
    std::vector<MotionStretch> stretches;
    const auto keys = track.keys();
    for (std::size_t i = 0; i + 1 < keys.size() && keys[i].time < end; ++i) {
        const double from = keys[i].time;
        const double duration = std::min(keys[i + 1].time, end) - from;
        const int looks = std::clamp(static_cast<int>(std::ceil(duration * kRate)), 1, kMostLooks);
        for (int look = 0; look < looks; ++look) {
            const double begin = from + duration * look / looks;
            const double middle = from + duration * (look + 0.5) / looks;
            const double close = from + duration * (look + 1) / looks;
            const Motion motion = motion_of(track.sample(middle), radius);
            if (motion == Motion::still) {
                continue;
            }
            const bool goes_on = !stretches.empty() && stretches.back().motion == motion &&
                                 stretches.back().to >= begin - 1e-9;
            if (!goes_on) {
                stretches.push_back(
                    {motion, begin, begin, {from_above(track.sample(begin).position)}});
            }
            stretches.back().points.push_back(from_above(track.sample(close).position));
            stretches.back().to = close;
        }
    }
    for (MotionStretch& stretch : stretches) {
        stretch.points = simplified(stretch.points, tolerance);
    }
    return stretches;
}

}  // namespace carom::pipeline
