// Measures how large a few pictures become in a film's codec, without writing a file.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "pipeline/video/video_format.h"

namespace carom::pipeline {

/// Encodes the pictures as the first frames of a film to `path`, which is not opened: 16-bit RGB as
/// in VideoWriter::write, each of the size of `format`. Returns the size of each picture, in bytes
/// and in the order of the film. Throws Error.
[[nodiscard]] std::vector<std::uint64_t> encoded_sizes(
    std::span<const std::vector<std::uint16_t>> pictures, const VideoFormat& format,
    const OutputSettings& output, const std::string& path);

}  // namespace carom::pipeline
