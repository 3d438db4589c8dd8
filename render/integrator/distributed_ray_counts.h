// How many rays the distributed integrator sends: known beforehand where nothing cuts them short.
#pragma once

#include <cstddef>
#include <string>

#include "render/film/film.h"
#include "render/scene/distributed_settings.h"
#include "render/scene/render_settings.h"

namespace carom::render {

/// All rays for one camera ray if every surface reflects and refracts, both with a spread, and
/// every ray meets a surface: the sum over generations n = 0 ... r of the rays of that generation
/// times (1 + lights x shadow samples). Without fall-off: sum of (R + T)^n (1 + L S). With R or T
/// left out
/// (`reflects`, `refracts`) for scenes where no surface does.
[[nodiscard]] double rays_per_camera_ray(const DistributedSettings& settings, std::size_t lights,
                                         bool reflects = true, bool refracts = true);

/// The classic estimate for one pixel: blur x lens x (L S + sum over n = 1 ... r of
/// 2 L S (R + T)^n), by the text that the older scene format comes from (its section 6.2).
[[nodiscard]] double rays_by_classic_formula(const DistributedSettings& settings,
                                             std::size_t lights);

/// More rays than this for one camera ray are refused: a frame of them would hardly end.
inline constexpr double kMostRaysPerCameraRay = 1e7;

/// What was counted beside both formulas, in lines of text that say why they differ.
[[nodiscard]] std::string describe_rays(const RenderStatistics& count,
                                        const RenderSettings& settings, std::size_t lights);

}  // namespace carom::render
