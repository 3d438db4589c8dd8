// A view of the page as a frame of a film.
#pragma once

#include "pipeline/camera/frame_plan.h"
#include "pipeline/studio/messages.h"

namespace carom::studio {

/// Without an exposure: it opens and closes at the view's scene time.
[[nodiscard]] pipeline::PlannedFrame frame_of(const FreeView& view);

}  // namespace carom::studio
