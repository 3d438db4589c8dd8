// What a film's sound takes materials and resonators to be, where a shot does not say it.
#pragma once

#include <string_view>

#include "sound/sound_scene.h"

namespace carom::sound {

/// The material of that name. "ball" and "phenolic" are the balls' resin, with the modulus that is
/// quoted for it most often, "tile" and "plastic" a hard plastic; "wood" and "hardwood" are a
/// hardwood along its grain; "steel", "glass", "slate" and "ivory" are what they say. All other
/// names are hardwood. The moduli are the middle of handbook ranges.
[[nodiscard]] Material default_material(std::string_view name);

/// The resonators of a billiard table, for balls of that mass (kg). A cushion is a spring of 55
/// kN/m, so that a ball touches it for pi sqrt(mass / k), 5.5 ms, at any speed. A leather tip
/// touches a ball for 1 to 2 ms (Alciatore's high-speed videos, billiards.colostate.edu; Jewett,
/// Billiards Digest, April 1999). The bed's first mode is that of a simply supported third of a
/// slate 25 mm thick, those of the stick are longitudinal and one that bends. No measurement was
/// found for the other times and for the gains: they were set beside the sound of two balls.
[[nodiscard]] Resonators default_resonators(double ball_mass = 0.170097);

}  // namespace carom::sound
