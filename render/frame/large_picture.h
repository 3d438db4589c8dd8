// Memory of large pictures. Internal to this folder.
#pragma once

#include <cstddef>

#include "core/free_memory.h"

namespace carom::render {

/// Hands freed memory back to the system, which takes some milliseconds: after work on a picture of
/// so many pixels, if they are worth it.
inline void give_back_memory_of(std::size_t pixels) {
    constexpr std::size_t kMany = std::size_t{1} << 20;
    if (pixels >= kMany) {
        give_back_freed_memory();
    }
}

}  // namespace carom::render
