// Settings that cannot be rendered with are refused before any work.
#pragma once

#include <string>
#include <vector>

#include "render/frame/frame.h"
#include "render/material/material.h"

namespace carom::render {

/// One sentence per value outside the range that its header states; empty: all is well.
[[nodiscard]] std::vector<std::string> problems_of(const RenderSettings& settings);
[[nodiscard]] std::vector<std::string> problems_of(const FrameInput& frame);

/// Throws Error if the settings' integrator cannot render with those materials and so many lights:
/// phong surfaces are the distributed integrator's, whose rays must not grow beyond all bounds.
void check_integrator(const RenderSettings& settings, const std::vector<Material>& materials,
                      std::size_t lights);

/// Throws Error with all sentences of both.
void check(const RenderSettings& settings, const FrameInput& frame);

}  // namespace carom::render
