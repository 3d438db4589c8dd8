// How the finished frames become a file.
#pragma once

#include <string>

namespace carom::pipeline {

/// raw: the numbers are shown as they are, for light that was computed in a display's own values.
enum class ViewTransform { srgb, filmic, raw };
enum class Codec { h264, ffv1 };

struct OutputSettings {
    Codec codec = Codec::h264;
    double crf = 18;                // [0, 51]
    std::string preset = "medium";  // of the encoder
    int threads = 2;                // of the encoder; x264's output depends on it
    ViewTransform view = ViewTransform::filmic;
    double exposure = 0;  // stops
};

}  // namespace carom::pipeline
