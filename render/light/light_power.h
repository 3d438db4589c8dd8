// How much light lamps send out.
#pragma once

#include <optional>

#include "core/vectors.h"
#include "render/scene/light_description.h"

namespace carom::render {

/// Lumens per watt of every colour's luminance: the efficacy of white light by the convention of
/// Ward 1994, "The RADIANCE lighting simulation and rendering system". 1 W/m^2 counts as 179 lx.
inline constexpr double kLumensPerWatt = 179;

/// Power, W, for each colour; nothing for lights without a surface. The light must have no problem
/// (problem_of).
[[nodiscard]] std::optional<Vec3> power_of(const LightDescription& light);

/// That of a matt disk in the shade's opening with the same power.
[[nodiscard]] Vec3 mean_radiance(const ShadeLight& light);

}  // namespace carom::render
