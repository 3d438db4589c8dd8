// Checks of settings before rendering.
#pragma once

#include <vector>

#include "core/diagnostic.h"
#include "render/frame/frame.h"
#include "render/scene/scene_problems.h"

namespace carom::render {

/// One problem per value outside the range stated at its declaration; fields are named as in a
/// shot. Empty if all values are valid.
[[nodiscard]] std::vector<Diagnostic> find_problems(const RenderSettings& settings,
                                                    const RayBranches& branches);
[[nodiscard]] std::vector<Diagnostic> find_problems(const FrameInput& frame);

/// Throws Error with the sentences of all problems of settings and frame.
void check(const RenderSettings& settings, const FrameInput& frame, const RayBranches& branches);

}  // namespace carom::render
