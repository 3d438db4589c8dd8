// The containers that can be written, and the codecs that each of them may hold.
#pragma once

#include <initializer_list>
#include <span>
#include <string>
#include <string_view>

#include "pipeline/video/output_settings.h"

namespace carom::pipeline {

struct Container {
    std::string_view extension;  // ".mp4"
    std::string_view muxer;      // the container's name in libavformat
    unsigned codecs = 0;         // one bit per codec
    Codec video{};               // the usual one
    unsigned audio_codecs = 0;   // likewise, of the sound
    AudioCodec audio{};          // the usual one

    [[nodiscard]] constexpr bool holds(Codec codec) const {
        return (codecs >> static_cast<unsigned>(codec) & 1U) != 0;
    }
    /// True for AudioCodec::none.
    [[nodiscard]] constexpr bool holds(AudioCodec codec) const {
        return codec == AudioCodec::none ||
               (audio_codecs >> static_cast<unsigned>(codec) & 1U) != 0;
    }
};

[[nodiscard]] std::span<const Container> containers();

/// The container that the path's extension names (in any case), or nullptr.
[[nodiscard]] const Container* find_container(const std::string& path);

/// "h264: .mp4, .mov, .mkv; ...; uncompressed: .avi"
[[nodiscard]] std::string list_containers();

/// "aac: .mp4, .mov; opus: ..."
[[nodiscard]] std::string list_audio_containers();

}  // namespace carom::pipeline
