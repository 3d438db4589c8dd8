// Version, limits and encoding steps shared by the writer and the reader of bake files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sim/timeline/bake_file.h"

namespace carom::sim {

/// Increased whenever an older reader would misunderstand or reject the file.
inline constexpr std::uint32_t kSchemaVersion = 3;

// Limits of one file, which find_problem checks.
inline constexpr std::size_t kMaxTracks = 65'536;
inline constexpr std::size_t kMaxAssets = 65'536;
inline constexpr std::size_t kMaxWarnings = 1'024;
inline constexpr std::size_t kLongestName = 1'024;                    // bytes
inline constexpr std::size_t kLongestSentence = 16'384;               // bytes
inline constexpr std::size_t kLongestPath = 4'096;                    // bytes
inline constexpr std::size_t kLargestContent = std::size_t{1} << 30;  // bytes

/// The first problem for which a bake cannot be written or must not be trusted, as a sentence
/// without its full stop.
[[nodiscard]] std::optional<std::string> find_problem(const Bake& bake);

/// The bytes of the file for an inner buffer (root Content); readers accept no others.
[[nodiscard]] std::vector<std::byte> encode_envelope(std::span<const std::byte> content);

/// The inner buffer.
[[nodiscard]] std::vector<std::byte> encode_content(const Bake& bake);

/// Decodes an inner buffer, aligned to eight bytes. Throws Error with the problem, without the
/// file's name.
[[nodiscard]] Bake decode_content(std::span<const std::byte> content);

}  // namespace carom::sim
