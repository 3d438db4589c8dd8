// A film as one picture per frame: "shot.####.exr".
#pragma once

#include <cstdint>
#include <string>

namespace carom::pipeline {

/// Whether the file name holds '#' (anywhere but in its extension).
[[nodiscard]] bool is_image_sequence(const std::string& path);

/// Empty, or a sentence about what is wrong with the pattern: two groups of '#', or an extension
/// that no picture has.
[[nodiscard]] std::string check_image_sequence(const std::string& path);

/// The frame's number in place of the '#', with zeros in front up to their count.
[[nodiscard]] std::string path_in_sequence(const std::string& pattern, std::int64_t frame);

}  // namespace carom::pipeline
