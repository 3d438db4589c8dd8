// The annotations in the scene at a time, as a message.
#pragma once

#include "pipeline/picture/text_extents.h"
#include "pipeline/shot/shot.h"
#include "pipeline/studio/messages.h"
#include "pipeline/studio/motion_messages.h"
#include "sim/timeline/timeline.h"

namespace carom::studio {

/// The answer to a question, without its version. `extents`: reads fonts when it needs them. Throws
/// Error if the view is none, or a font cannot be read.
[[nodiscard]] Numbers<AnnotationsHead> annotations_message(const pipeline::Shot& shot,
                                                           const sim::Timeline& timeline,
                                                           const SeeAnnotations& question,
                                                           pipeline::TextExtents& extents);

}  // namespace carom::studio
