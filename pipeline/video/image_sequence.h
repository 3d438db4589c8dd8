// Films that are written as one image file per frame: "shot.####.exr".
#pragma once

#include <cstdint>
#include <string>

namespace carom::pipeline {

/// Whether the file name contains '#' (anywhere except in its extension).
[[nodiscard]] bool is_image_sequence(const std::string& path);

/// Empty, or a sentence that says what is wrong with the pattern: two groups of '#', or an
/// extension that is not an image format.
[[nodiscard]] std::string check_image_sequence(const std::string& path);

/// The pattern with the group of '#' replaced by the frame number, zero-padded to the length of the
/// group.
[[nodiscard]] std::string path_in_sequence(const std::string& pattern, std::int64_t frame);

/// The file beside the pictures that has their sound: the pattern without the group of '#' and the
/// punctuation before it, with the extension .wav. "shot.wav" for "shot.####.exr", "sound.wav" for
/// "####.png".
[[nodiscard]] std::string sound_path_of_sequence(const std::string& pattern);

}  // namespace carom::pipeline
