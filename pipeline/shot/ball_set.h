// The usual sets of balls: sizes, masses and colours.
#pragma once

#include <string_view>

#include "render/scene/material_description.h"

namespace carom::pipeline {

enum class BallSet { pool, snooker, carom };

/// Size and mass of a set's balls.
struct BallMeasures {
    double radius = 0;  // m
    double mass = 0;    // kg
};

[[nodiscard]] BallMeasures ball_measures(BallSet set);

/// The texture of the ball of that name: "one" to "fifteen" and "cue" in pool, "red_1" ...,
/// "yellow" ... and "cue" in snooker, "white", "yellow" and "red" in carom. A ball with any other
/// name is plain white.
[[nodiscard]] render::BallTexture ball_texture(BallSet set, std::string_view name);

}  // namespace carom::pipeline
