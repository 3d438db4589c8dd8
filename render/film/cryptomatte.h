// Mattes by name in a picture's own channels, as compositors read them: J. Friedman and A. C.
// Jones, "Fully automatic ID mattes with support for motion blur and transparency", SIGGRAPH 2015
// posters; the layout is that of Psyop's "Cryptomatte Specification", version 1.2.
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

/// The number that stands for a name in the channels: the hash's bits as a float, its exponent
/// moved off 0 and 255 so that it is neither denormal nor infinite nor NaN.
[[nodiscard]] float matte_id(std::string_view name);

/// What a pixel shows most of comes first; six things at most.
inline constexpr std::size_t kMatteRanks = 6;

struct MatteRank {
    float id = 0;        // 0 with coverage 0: nothing further
    float coverage = 0;  // share of the pixel's samples, [0, 1]

    bool operator==(const MatteRank&) const = default;
};
using MatteRanks = std::array<MatteRank, kMatteRanks>;

/// Largest coverage first; equal ids count as one, equal coverages stay in the order given.
[[nodiscard]] MatteRanks ranked(const std::vector<MatteRank>& seen);

/// "LAYER00.R", id of the first rank; .G its coverage; .B and .A the second's; "LAYER01.R" ...
[[nodiscard]] std::vector<std::string> matte_channels(std::string_view layer);

/// What a file's header says of the layer: "cryptomatte/ID/name", hash, conversion and manifest,
/// which maps `names` to their hashes.
[[nodiscard]] Film::Notes matte_notes(std::string_view layer,
                                      const std::vector<std::string>& names);

}  // namespace carom::render
