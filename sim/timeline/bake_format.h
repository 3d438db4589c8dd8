// What the writer and the reader of the bake file agree on.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sim/timeline/bake_file.h"

namespace carom::sim {

/// Raised when a reader of the older kind would misunderstand or refuse the file.
inline constexpr std::uint32_t kSchemaVersion = 2;

// Limits of one file; find_problem says when a bake is beyond them.
inline constexpr std::size_t kMostTracks = 65'536;
inline constexpr std::size_t kMostAssets = 65'536;
inline constexpr std::size_t kMostWarnings = 1'024;
inline constexpr std::size_t kLongestName = 1'024;                    // bytes
inline constexpr std::size_t kLongestSentence = 16'384;               // bytes
inline constexpr std::size_t kLongestPath = 4'096;                    // bytes
inline constexpr std::size_t kLargestContent = std::size_t{1} << 30;  // bytes

/// Why a bake cannot be written, or must not be believed: a sentence without its full stop, for
/// the first thing found.
[[nodiscard]] std::optional<std::string> find_problem(const Bake& bake);

/// The file's bytes around the inner buffer (root Content); the only ones that are accepted for it.
[[nodiscard]] std::vector<std::byte> encode_envelope(std::span<const std::byte> content);

/// The inner buffer.
[[nodiscard]] std::vector<std::byte> encode_content(const Bake& bake);

/// Reads an inner buffer, aligned to eight bytes. Throws Error with a sentence about what is wrong,
/// without the file's name.
[[nodiscard]] Bake decode_content(std::span<const std::byte> content);

}  // namespace carom::sim
