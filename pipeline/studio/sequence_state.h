// What the page draws and edits of a film of several shots.
#pragma once

#include "pipeline/sequence/sequence.h"
#include "pipeline/studio/messages.h"

namespace carom::studio {

/// The whole state but for its version and its places.
[[nodiscard]] SequenceState sequence_state(const pipeline::Sequence& sequence);

}  // namespace carom::studio
