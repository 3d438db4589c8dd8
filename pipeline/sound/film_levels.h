// How loud a film is over its time, for drawings.
#pragma once

#include <vector>

#include "core/progress.h"
#include "pipeline/shot/shot.h"
#include "sim/timeline/timeline.h"

namespace carom::pipeline {

/// Levels of a film's sound at even distances of film time.
struct FilmLevels {
    static constexpr double kInterval = 0.05;  // s

    /// Of each interval from the film's start on, the root mean square of both channels in dB of
    /// full scale; minus infinity for silence. Empty: the film has no sound.
    std::vector<double> decibels;

    /// The film's length, s.
    double length = 0;
};

/// Mixes the shot's film; empty if it is silent. `timeline` as in film_scene (film_scene.h). Throws
/// Stopped.
[[nodiscard]] FilmLevels film_levels(const Shot& shot, const sim::Timeline& timeline,
                                     const WorkContext& context = {});

}  // namespace carom::pipeline
