// Opens encoders with carom's settings for each codec.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "pipeline/video/av_library.h"
#include "pipeline/video/output_settings.h"
#include "pipeline/video/video_format.h"
#include "pipeline/video/yuv_conversion.h"

namespace carom::pipeline {

/// Opens the encoder of codec_for(output, path). Its time base is one frame. `global_header`: the
/// container stores the codec's parameters in its own header. Throws Error naming `path`.
[[nodiscard]] AvPtr<AVCodecContext> open_encoder(const VideoFormat& format,
                                                 const OutputSettings& output, bool global_header,
                                                 const std::string& path);

/// Sets the packet's decoding time; decoding times are one frame apart. x265 3.5 leaves those of a
/// film of one or two frames uninitialised (Multicorewareinc/x265 issue 781). `packet` is number
/// `index` of the encoder's packets, counted from 0, in its time base.
void set_decoding_time(AVPacket& packet, const AVCodecContext& encoder, std::int64_t index);

/// Converts a picture (16-bit RGB, encoded as the film is) to the pixel format of `frame` and
/// stores it there.
void fill_frame(AVFrame& frame, std::span<const std::uint16_t> rgb);

/// The planes of a frame in 10-bit Y'CbCr.
[[nodiscard]] YuvPlanes<std::uint16_t> yuv10_planes(AVFrame& frame);

}  // namespace carom::pipeline
