#include "pipeline/plan/sheet.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace carom::pipeline {

namespace {

/// The smallest of 1, 1.25, 1.5, 2 ... 8 times a power of ten that is at least `least`.
double usual_denominator(double least) {
    constexpr std::array<double, 10> kSteps{1, 1.25, 1.5, 2, 2.5, 3, 4, 5, 6, 8};
    const double decade = std::pow(10, std::floor(std::log10(least)));
    for (const double step : kSteps) {
        if (step * decade >= least * (1 - 1e-9)) {
            return step * decade;
        }
    }
    return 10 * decade;
}

}  // namespace

Sheet make_sheet(const Vec2& low, const Vec2& high, const Vec2& room) {
    Sheet sheet;
    sheet.low = low;
    sheet.high = high;
    const double least =
        std::max({1000 * (high.x - low.x) / room.x, 1000 * (high.y - low.y) / room.y, 1e-3});
    sheet.denominator = usual_denominator(least);
    return sheet;
}

}  // namespace carom::pipeline
