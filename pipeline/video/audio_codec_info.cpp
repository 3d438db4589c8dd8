#include "pipeline/video/audio_codec_info.h"

#include <array>

#include "core/assert.h"
#include "pipeline/video/codec_info.h"
#include "pipeline/video/container.h"

namespace carom::pipeline {

namespace {

constexpr std::array kAudioCodecs{
    AudioCodecInfo{AudioCodec::aac, "aac", "aac", 256e3},
    AudioCodecInfo{AudioCodec::opus, "opus", "libopus", 192e3},
    AudioCodecInfo{AudioCodec::flac, "flac", "flac", 0},
    AudioCodecInfo{AudioCodec::pcm, "pcm", "pcm_s24le", 0},
};

}  // namespace

std::span<const AudioCodecInfo> audio_codecs() {
    return kAudioCodecs;
}

const AudioCodecInfo& info(AudioCodec codec) {
    const auto index = static_cast<std::size_t>(codec);
    CAROM_ASSERT(index < kAudioCodecs.size() && kAudioCodecs[index].codec == codec);
    return kAudioCodecs[index];
}

std::string to_string(AudioCodec codec) {
    return codec == AudioCodec::none ? "none" : std::string(info(codec).name);
}

AudioCodec audio_codec_for(const OutputSettings& output, const std::string& path) {
    if (output.audio) {
        return *output.audio;
    }
    const Container* container = find_container(path);
    if (container == nullptr) {
        return AudioCodec::none;
    }
    const bool is_for_editing = codec_for(output, path) == Codec::prores;
    return is_for_editing && container->muxer == "mov" ? AudioCodec::pcm : container->audio;
}

double audio_bit_rate_of(const OutputSettings& output, AudioCodec codec) {
    const double usual = info(codec).bit_rate;
    return usual > 0 ? output.audio_bit_rate.value_or(usual) : 0;
}

}  // namespace carom::pipeline
