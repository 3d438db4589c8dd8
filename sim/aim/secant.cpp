#include "sim/aim/secant.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace carom::sim {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kFarthest = std::numbers::pi / 2;  // of a direction from the first one

struct Point {
    double direction = 0;
    double miss = 0;
};

/// The slope through two points, if they are two and it has the right sign.
std::optional<double> slope_of(const std::optional<Point>& before, const Point& now) {
    if (!before || before->direction == now.direction) {
        return std::nullopt;
    }
    const double slope = (now.miss - before->miss) / (now.direction - before->direction);
    return slope > 0 ? std::optional(slope) : std::nullopt;
}

}  // namespace

std::int64_t to_microdegrees(double radians) {
    return std::llround(radians / kDegree * 1e6);
}

double from_microdegrees(std::int64_t microdegrees) {
    return static_cast<double>(microdegrees) / 1e6 * kDegree;
}

Solved solve_direction(double start, double tolerance, const std::function<Miss(double)>& miss_of) {
    Solved best;
    std::optional<Point> before;
    std::optional<double> right,
        left;  // the nearest directions that are too far to the right, left
    double at = from_microdegrees(to_microdegrees(start));
    for (int i = 0; i < kMostSecants; ++i) {
        const Miss miss = miss_of(at);
        double next = miss.nearer;
        if (miss.value) {
            const Point now{at, *miss.value};
            if (!best.direction || std::abs(now.miss) < std::abs(best.miss)) {
                best.direction = at;
                best.miss = now.miss;
            }
            if (std::abs(now.miss) <= tolerance) {
                break;
            }
            next = at - now.miss / slope_of(before, now).value_or(miss.slope);
            before = now;
        } else if (miss.too_far == 0) {
            best.instead = miss.instead;
            break;
        }
        ((miss.value ? *miss.value > 0 : miss.too_far > 0) ? left : right) = at;
        if (left && right && !(next > *right && next < *left)) {
            next = 0.5 * (*left + *right);
        }
        if (!std::isfinite(next)) {
            break;
        }
        next = std::clamp(next, start - kFarthest, start + kFarthest);
        next = from_microdegrees(to_microdegrees(next));
        if (next == at) {
            break;
        }
        at = next;
    }
    return best;
}

}  // namespace carom::sim
