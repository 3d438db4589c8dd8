// What each codec can do, as its encoder is used here.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "pipeline/video/output_settings.h"

namespace carom::pipeline {

struct CodecInfo {
    Codec codec{};
    std::string_view name;       // as shots spell it
    std::string_view extension;  // of its files unless told otherwise: ".mp4"
    std::string_view encoder;    // libavcodec's name of it
    int bits = 8;                // per channel unless told otherwise
    bool has_choice_of_bits = false;
    double crf = 0;        // unless told otherwise
    double worst_crf = 0;  // 0: the codec's quality is fixed, and so is its bit rate
    bool halves_width = false;
    bool halves_height = false;  // of the colour planes
    bool has_levels = false;     // that end at pictures of 35.6 million pixels
};

[[nodiscard]] std::span<const CodecInfo> codecs();
[[nodiscard]] const CodecInfo& info(Codec codec);

/// "h264", "ffv1".
[[nodiscard]] std::string to_string(Codec codec);

/// The codec that the settings name, else the one that files of the path's extension usually hold:
/// vp9 for .webm, h264 for all others; hevc for hdr10.
[[nodiscard]] Codec codec_for(const OutputSettings& output, const std::string& path);

/// Bits per channel of a film in this codec.
[[nodiscard]] int bits_of(const OutputSettings& output, Codec codec);

}  // namespace carom::pipeline
