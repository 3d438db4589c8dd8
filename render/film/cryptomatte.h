// Cryptomatte channels: J. Friedman and A. C. Jones, "Fully automatic ID mattes with support for
// motion blur and transparency", SIGGRAPH 2015 posters, with the layout of Psyop's "Cryptomatte
// Specification", version 1.2.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "render/film/film.h"

namespace carom::render {

/// A. Appleby's MurmurHash3, the 32-bit variant for x86, with seed 0.
[[nodiscard]] std::uint32_t murmur_hash3_32(std::string_view text);

/// The ID of a name in the channels: the hash's bits as a float, with the exponent kept off 0 and
/// 255 so that it is never denormal, infinite or NaN.
[[nodiscard]] float matte_id(std::string_view name);

/// Number of objects or materials that a pixel stores, those of largest coverage first.
inline constexpr std::size_t kMatteRanks = 6;

struct MatteRank {
    float id = 0;        // 0 with coverage 0: unused
    float coverage = 0;  // fraction of the pixel's samples, [0, 1]

    bool operator==(const MatteRank&) const = default;
};
using MatteRanks = std::array<MatteRank, kMatteRanks>;

/// Sorted by coverage, the largest first; equal ids are merged, equal coverages keep their order.
[[nodiscard]] MatteRanks ranked(const std::vector<MatteRank>& entries);

/// "LAYER00.R", id of the first rank; .G its coverage; .B and .A those of the second; "LAYER01.R"
/// ...
[[nodiscard]] std::vector<std::string> matte_channels(std::string_view layer);

/// The header entries of the layer: "cryptomatte/ID/name", hash, conversion, and the manifest,
/// which maps `names` to their hashes.
[[nodiscard]] Film::Notes matte_notes(std::string_view layer,
                                      const std::vector<std::string>& names);

}  // namespace carom::render
