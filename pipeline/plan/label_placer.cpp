#include "pipeline/plan/label_placer.h"

#include <algorithm>
#include <cmath>

namespace carom::pipeline {

namespace {

constexpr int kDirections = 16;
constexpr int kRings = 7;
constexpr double kRingStep = 2.2;        // mm
constexpr double kPerMillimetre = 0.45;  // cost of 1 mm of distance, in mm^2 of covered area
constexpr double kTurn = 6.283185307179586;

double overlap(const PaperBox& a, const PaperBox& b) {
    const double x = std::min(a.high.x, b.high.x) - std::max(a.low.x, b.low.x);
    const double y = std::min(a.high.y, b.high.y) - std::max(a.low.y, b.low.y);
    return x > 0 && y > 0 ? x * y : 0;
}

double area(const PaperBox& box) {
    return (box.high.x - box.low.x) * (box.high.y - box.low.y);
}

}  // namespace

void LabelPlacer::keep_free(const PaperBox& box, double weight) {
    taken_.push_back({box, weight});
}

double LabelPlacer::cost(const PaperBox& box) const {
    double sum = 10 * (area(box) - overlap(box, paper_));
    for (const Taken& taken : taken_) {
        sum += taken.weight * overlap(box, taken.box);
    }
    return sum;
}

Vec2 LabelPlacer::place(const Vec2& place, const Vec2& size, double gap) {
    PaperBox best;
    double least = 1e300;
    for (int ring = 0; ring < kRings; ++ring) {
        const double away = gap + ring * kRingStep;
        for (int i = 0; i < kDirections; ++i) {
            const double angle = kTurn * (i + 0.5) / kDirections;
            const Vec2 direction(std::cos(angle), -std::sin(angle));
            // The distance at which the nearest side of the box is `gap` away.
            const Vec2 centre = place + direction * away + 0.5 * size * direction;
            const PaperBox box{centre - 0.5 * size, centre + 0.5 * size};
            const double total = cost(box) + kPerMillimetre * ring * kRingStep;
            if (total < least - 1e-9) {
                least = total;
                best = box;
            }
        }
    }
    keep_free(best);
    return best.low;
}

}  // namespace carom::pipeline
