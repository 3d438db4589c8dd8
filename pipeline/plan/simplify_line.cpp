#include "pipeline/plan/simplify_line.h"

#include <algorithm>
#include <utility>

namespace carom::pipeline {

namespace {

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

}  // namespace

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

}  // namespace carom::pipeline
