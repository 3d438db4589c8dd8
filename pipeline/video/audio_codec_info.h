// Properties of each codec of the sound, as its encoder is used here.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "pipeline/video/output_settings.h"

namespace carom::pipeline {

inline constexpr double kLeastAudioBitRate = 32e3;  // bit/s
inline constexpr double kMostAudioBitRate = 512e3;  // of two channels; Opus ends there (RFC 6716)

/// Whether it is in that range.
[[nodiscard]] constexpr bool is_audio_bit_rate(double bit_rate) {
    return bit_rate >= kLeastAudioBitRate && bit_rate <= kMostAudioBitRate;
}

struct AudioCodecInfo {
    AudioCodec codec{};
    std::string_view name;     // as written in shots
    std::string_view encoder;  // the encoder's name in libavcodec
    double bit_rate = 0;       // bit/s, the default; 0: it is lossless, with 24 bits a sample
};

/// All codecs, without AudioCodec::none.
[[nodiscard]] std::span<const AudioCodecInfo> audio_codecs();

/// `codec` must not be AudioCodec::none.
[[nodiscard]] const AudioCodecInfo& info(AudioCodec codec);

/// "aac", "none".
[[nodiscard]] std::string to_string(AudioCodec codec);

/// The codec of a film's sound that the settings name. If they name none: pcm for prores in .mov,
/// otherwise the usual codec of the path's extension (container.h), and none if there is no such
/// container.
[[nodiscard]] AudioCodec audio_codec_for(const OutputSettings& output, const std::string& path);

/// The bit rate of the sound, in bit/s; 0 for codecs without one.
[[nodiscard]] double audio_bit_rate_of(const OutputSettings& output, AudioCodec codec);

}  // namespace carom::pipeline
