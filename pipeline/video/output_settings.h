// How the finished frames become a file.
#pragma once

#include <string>

namespace carom::pipeline {

/// ocio: by the OpenColorIO configuration that the environment variable OCIO names; raw: the
/// numbers are shown as they are, for light that was computed in a display's own values.
enum class ViewTransform { srgb, filmic, agx, ocio, raw };
enum class Codec { h264, ffv1 };

/// Names out of an OpenColorIO configuration; empty: its defaults (render/film/ocio_view.h).
struct OcioSettings {
    std::string display;
    std::string view;
    std::string colour_space;
};

/// See glow.h.
struct GlowSettings {
    double strength = 0;   // share of all light that is scattered, [0, 1]; 0: none
    double radius = 0.04;  // of the widest part of the glow, in picture heights, (0, 1]
};

struct OutputSettings {
    Codec codec = Codec::h264;
    double crf = 18;                // [0, 51]
    std::string preset = "medium";  // of the encoder
    int threads = 2;                // of the encoder; x264's output depends on it
    ViewTransform view = ViewTransform::filmic;
    OcioSettings ocio;    // with that view only
    double exposure = 0;  // stops
    GlowSettings glow;    // on the linear film, before the view
};

}  // namespace carom::pipeline
