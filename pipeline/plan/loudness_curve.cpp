#include "pipeline/plan/loudness_curve.h"

#include <algorithm>
#include <cstddef>

namespace carom::pipeline {

std::vector<Vec2> loudness_curve(const FilmLevels& sound, const TimeAxis& axis, double top,
                                 double bottom) {
    std::vector<Vec2> curve;
    for (std::size_t i = 0; i < sound.decibels.size(); ++i) {
        const double level = std::clamp(sound.decibels[i], kQuietest, 0.0);
        const double y = top + (bottom - top) * level / kQuietest;
        const double from = FilmLevels::kInterval * static_cast<double>(i);
        curve.emplace_back(axis.at(from), y);
        curve.emplace_back(axis.at(std::min(from + FilmLevels::kInterval, sound.length)), y);
    }
    return curve;
}

std::vector<Vec2> area_below(std::vector<Vec2> curve, double bottom) {
    if (!curve.empty()) {
        curve.insert(curve.begin(), {curve.front().x, bottom});
        curve.emplace_back(curve.back().x, bottom);
    }
    return curve;
}

}  // namespace carom::pipeline
