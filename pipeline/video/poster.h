// The picture that stands for a film, as a JPEG inside its file.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "pipeline/video/av_library.h"

namespace carom::pipeline {

/// Makes a new stream of the container one for a poster.
void describe_poster(AVStream& stream, int width, int height);

/// 8-bit sRGB-encoded RGB, width * height * 3, as a packet for such a stream. Throws Error naming
/// `path`.
[[nodiscard]] AvPtr<AVPacket> encode_poster(std::span<const std::uint8_t> rgb, int width,
                                            int height, const std::string& path);

}  // namespace carom::pipeline
