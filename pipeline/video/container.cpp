#include "pipeline/video/container.h"

#include <array>

#include "pipeline/video/audio_codec_info.h"
#include "pipeline/video/codec_info.h"
#include "pipeline/video/picture_kind.h"

namespace carom::pipeline {

namespace {

template <class T>
constexpr unsigned bits(std::initializer_list<T> codecs) {
    unsigned all = 0;
    for (const T codec : codecs) {
        all |= 1U << static_cast<unsigned>(codec);
    }
    return all;
}

// Matroska stores no edit list, so that the samples which an AAC decoder gives before the first one
// would move all times: the first picture would be shown 21 ms late. (Measured with libavformat
// 59.27; Opus states these samples in the stream itself.)
constexpr std::array kContainers{
    Container{".mp4", "mp4", bits({Codec::h264, Codec::hevc, Codec::av1, Codec::vp9}), Codec::h264,
              bits({AudioCodec::aac}), AudioCodec::aac},
    Container{".mov", "mov", bits({Codec::h264, Codec::hevc, Codec::prores}), Codec::h264,
              bits({AudioCodec::aac, AudioCodec::pcm}), AudioCodec::aac},
    Container{".mkv", "matroska",
              bits({Codec::h264, Codec::hevc, Codec::av1, Codec::vp9, Codec::prores, Codec::ffv1}),
              Codec::h264, bits({AudioCodec::opus, AudioCodec::flac, AudioCodec::pcm}),
              AudioCodec::flac},
    Container{".webm", "webm", bits({Codec::vp9, Codec::av1}), Codec::vp9, bits({AudioCodec::opus}),
              AudioCodec::opus},
    // The times of pictures that are not in order (H.264 and its like) cannot be stated in AVI.
    Container{".avi", "avi", bits({Codec::mjpeg, Codec::uncompressed}), Codec::mjpeg,
              bits({AudioCodec::pcm}), AudioCodec::pcm},
};

/// "NAME: .mp4, .mov; NAME: .mkv", for what codec_info.h or audio_codec_info.h lists.
template <class Infos>
std::string list_by_name(const Infos& infos) {
    std::string text;
    for (const auto& codec : infos) {
        text += (text.empty() ? "" : "; ") + std::string(codec.name) + ":";
        const char* separator = " ";
        for (const Container& container : kContainers) {
            if (container.holds(codec.codec)) {
                text += separator + std::string(container.extension);
                separator = ", ";
            }
        }
    }
    return text;
}

}  // namespace

std::span<const Container> containers() {
    return kContainers;
}

const Container* find_container(const std::string& path) {
    const std::string extension = extension_of(path);
    for (const Container& container : kContainers) {
        if (container.extension == extension) {
            return &container;
        }
    }
    return nullptr;
}

std::string list_containers() {
    return list_by_name(codecs());
}

std::string list_audio_containers() {
    return list_by_name(audio_codecs());
}

}  // namespace carom::pipeline
