// Properties of each codec, as its encoder is used here.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "pipeline/video/output_settings.h"

namespace carom::pipeline {

struct CodecInfo {
    Codec codec{};
    std::string_view name;       // as written in shots
    std::string_view extension;  // the default extension of its files: ".mp4"
    std::string_view encoder;    // the encoder's name in libavcodec
    int bits = 8;                // per channel, by default
    bool has_choice_of_bits = false;
    double crf = 0;        // the default
    double worst_crf = 0;  // 0: the codec's quality is fixed, so it takes no bit rate either
    bool halves_width = false;
    bool halves_height = false;  // both: of the colour planes
    bool has_levels = false;     // whose maximum is 35.6 million pixels per picture
    bool is_intra_only = false;  // every picture is coded by itself
};

[[nodiscard]] std::span<const CodecInfo> codecs();
[[nodiscard]] const CodecInfo& info(Codec codec);

/// "h264", "ffv1".
[[nodiscard]] std::string to_string(Codec codec);

/// The codec that the settings name. If they name none: hevc for hdr10, otherwise the usual codec
/// of the path's extension (container.h), which is h264 for most.
[[nodiscard]] Codec codec_for(const OutputSettings& output, const std::string& path);

/// Bits per channel of a film in this codec.
[[nodiscard]] int bits_of(const OutputSettings& output, Codec codec);

}  // namespace carom::pipeline
