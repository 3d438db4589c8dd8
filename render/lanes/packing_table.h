// Which of eight lanes move to the front for each of their 256 masks.
#pragma once

#include <array>
#include <cstdint>

namespace carom::render {

/// Four bits for each place, the lowest for the first: the lane that moves there. Places behind the
/// last lane of the mask have lane 0.
inline constexpr std::array<std::uint32_t, 256> kPackingTable = [] {
    std::array<std::uint32_t, 256> table{};
    for (std::uint32_t mask = 0; mask < table.size(); ++mask) {
        std::uint32_t place = 0;
        for (std::uint32_t lane = 0; lane < 8; ++lane) {
            if ((mask >> lane & 1u) != 0) {
                table[mask] |= lane << 4 * place;
                ++place;
            }
        }
    }
    return table;
}();

}  // namespace carom::render
