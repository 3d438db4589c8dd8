// How the finished frames become a file.
#pragma once

#include <string>

namespace carom::pipeline {

enum class ViewTransform { srgb, filmic };
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
