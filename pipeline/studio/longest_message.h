// How long the messages of a page may be.
#pragma once

#include <cstddef>

namespace carom::studio {

/// Bytes of the longest message that the page may send.
inline constexpr std::size_t kLongestMessage = 4 << 20;

}  // namespace carom::studio
