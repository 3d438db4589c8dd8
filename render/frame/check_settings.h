// Settings that cannot be rendered with are refused before any work.
#pragma once

#include <vector>

#include "core/diagnostic.h"
#include "render/frame/frame.h"
#include "render/scene/scene_problems.h"

namespace carom::render {

/// One problem per value outside the range that its header states; the fields are called as in a
/// shot's file. Empty: all is well.
[[nodiscard]] std::vector<Diagnostic> find_problems(const RenderSettings& settings,
                                                    const RayBranches& branches);
[[nodiscard]] std::vector<Diagnostic> find_problems(const FrameInput& frame);

/// Throws Error with all sentences of both.
void check(const RenderSettings& settings, const FrameInput& frame, const RayBranches& branches);

}  // namespace carom::render
