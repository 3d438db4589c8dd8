// An opened encoder, for each codec with the settings that carom writes it with.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "pipeline/video/av_library.h"
#include "pipeline/video/output_settings.h"
#include "pipeline/video/video_format.h"

namespace carom::pipeline {

/// The encoder of codec_for(output, path), opened. Its time base is one frame. `global_header`: the
/// container wants the codec's parameters in its own header. Throws Error naming `path`.
[[nodiscard]] AvPtr<AVCodecContext> open_encoder(const VideoFormat& format,
                                                 const OutputSettings& output, bool global_header,
                                                 const std::string& path);

/// Puts a picture (16-bit RGB, encoded as the film is) into `frame`, in the encoder's own pixel
/// format.
void fill_frame(AVFrame& frame, std::span<const std::uint16_t> rgb);

}  // namespace carom::pipeline
