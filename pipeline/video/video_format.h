// What a film's file is: size, rate and container, and whether its codec can take them.
#pragma once

#include <string>

#include "pipeline/camera/rational.h"
#include "pipeline/video/output_settings.h"

namespace carom::pipeline {

struct VideoFormat {
    int width = 0;  // pixels; even for h264 (check_video_format says so)
    int height = 0;
    Rational fps{24};
};

/// Empty, or a sentence that says what the codec cannot take and what to do about it. Needs no
/// encoder: a shot is checked with it long before its film is written.
[[nodiscard]] std::string check_video_format(const VideoFormat& format,
                                             const OutputSettings& output, const std::string& path);

/// The extension that a codec's files have unless told otherwise, with its dot: ".mp4".
[[nodiscard]] std::string default_extension(Codec codec);

/// "h264", "ffv1".
[[nodiscard]] std::string to_string(Codec codec);

}  // namespace carom::pipeline
