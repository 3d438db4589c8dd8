// The samples of frames that were stopped, beside the finished frames of a store.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/hash.h"
#include "pipeline/store/frame_store.h"
#include "render/frame/frame_sums.h"

namespace carom::pipeline {

/// Writes the sums under a temporary name, flushes them to disk and renames them. Throws Error.
void write_sums(const FrameStore& store, const Hash128& key, const render::FrameSums& sums);

/// The sums that another process or an earlier run has written of the frame with this key and
/// number of pixels; empty ones if there are none or they are damaged.
[[nodiscard]] render::FrameSums read_sums(const FrameStore& store, const Hash128& key,
                                          std::size_t pixels);

/// How many samples the stored sums of the frame have, as their file says, which is not read to its
/// end; 0 if there are none.
[[nodiscard]] std::uint64_t stored_samples(const FrameStore& store, const Hash128& key);

/// Removes them, when the frame is there.
void remove_sums(const FrameStore& store, const Hash128& key);

}  // namespace carom::pipeline
