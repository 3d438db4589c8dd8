// Settings that cannot be rendered with are refused before any work.
#pragma once

#include <string>
#include <vector>

#include "render/frame/frame.h"

namespace carom::render {

/// One sentence per value outside the range that its header states; empty: all is well.
[[nodiscard]] std::vector<std::string> problems_of(const RenderSettings& settings);
[[nodiscard]] std::vector<std::string> problems_of(const FrameInput& frame);

/// Throws Error with all sentences of both.
void check(const RenderSettings& settings, const FrameInput& frame);

}  // namespace carom::render
