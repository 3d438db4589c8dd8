// The poster: a JPEG inside a film's file that file lists show as its preview.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "pipeline/video/av_library.h"

namespace carom::pipeline {

/// Sets the parameters of a new stream of the container to those of a poster.
void describe_poster(AVStream& stream, int width, int height);

/// Encodes 8-bit sRGB-encoded RGB, width * height * 3, as a packet for such a stream. Throws Error
/// naming `path`.
[[nodiscard]] AvPtr<AVPacket> encode_poster(std::span<const std::uint8_t> rgb, int width,
                                            int height, const std::string& path);

}  // namespace carom::pipeline
