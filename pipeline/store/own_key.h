// How the keys of this version's frames are told from those of other versions.
#pragma once

#include <cstdint>

#include "core/hash.h"
#include "render/frame/frame.h"

namespace carom::pipeline {

/// Of what the keys of frames are made and how.
inline constexpr int kFrameKeyFormat = 4;

/// The key that is made of a frame's hash: its last four digits are the key format and the
/// renderer's revision.
[[nodiscard]] constexpr Hash128 own_key(const Hash128& hash) {
    static_assert(kFrameKeyFormat < 0x100 && render::kRendererRevision < 0x100);
    constexpr std::uint64_t kVersion = kFrameKeyFormat << 8 | render::kRendererRevision;
    return {hash.high, (hash.low & ~std::uint64_t{0xffff}) | kVersion};
}

/// False for the keys of other formats and revisions, whose frames this version never reads (but
/// for one in 65,536 of the keys that were written before keys told their format).
[[nodiscard]] constexpr bool is_own_key(const Hash128& key) {
    return key.low == own_key(key).low;
}

}  // namespace carom::pipeline
