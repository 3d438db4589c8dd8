// Takes a frame out of a store, so that it is rendered again.
#pragma once

#include "core/hash.h"
#include "pipeline/store/frame_store.h"

namespace carom::pipeline {

/// Removes the picture, that before it was denoised (`noisy_key`, or the same key) and the samples
/// of a stopped attempt, under the claims with which pictures are rendered. If none of them is
/// there, nothing has to be done, and no claim matters. Returns false, and removes nothing, if
/// another process renders it just now, or has died on another machine: who wants it then calls
/// again, at least once a second, until the time after which a claim counts as dead. Throws Error.
[[nodiscard]] bool drop_frame(const FrameStore& store, const Hash128& key,
                              const Hash128& noisy_key);

}  // namespace carom::pipeline
