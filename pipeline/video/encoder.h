// An opened encoder, for each codec with the settings that carom writes it with.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "pipeline/video/av_library.h"
#include "pipeline/video/output_settings.h"
#include "pipeline/video/video_format.h"
#include "pipeline/video/yuv_conversion.h"

namespace carom::pipeline {

/// The encoder of codec_for(output, path), opened. Its time base is one frame. `global_header`: the
/// container wants the codec's parameters in its own header. Throws Error naming `path`.
[[nodiscard]] AvPtr<AVCodecContext> open_encoder(const VideoFormat& format,
                                                 const OutputSettings& output, bool global_header,
                                                 const std::string& path);

/// Decoding times are one frame apart. x265 3.5 leaves those of a film of one or two frames
/// to what memory held before (Multicorewareinc/x265 issue 781), so that they are set here:
/// `packet` is the encoder's `index`-th from 0, in its time base.
void set_decoding_time(AVPacket& packet, const AVCodecContext& encoder, std::int64_t index);

/// Puts a picture (16-bit RGB, encoded as the film is) into `frame`, in the encoder's own pixel
/// format.
void fill_frame(AVFrame& frame, std::span<const std::uint16_t> rgb);

/// Of a frame in 10-bit Y'CbCr.
[[nodiscard]] YuvPlanes<std::uint16_t> yuv10_planes(AVFrame& frame);

}  // namespace carom::pipeline
