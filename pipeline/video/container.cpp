#include "pipeline/video/container.h"

#include <array>

#include "pipeline/video/codec_info.h"
#include "pipeline/video/picture_kind.h"

namespace carom::pipeline {

namespace {

constexpr unsigned bits(std::initializer_list<Codec> codecs) {
    unsigned all = 0;
    for (const Codec codec : codecs) {
        all |= 1U << static_cast<unsigned>(codec);
    }
    return all;
}

constexpr std::array kContainers{
    Container{".mp4", "mp4", bits({Codec::h264, Codec::hevc, Codec::av1, Codec::vp9})},
    Container{".mov", "mov", bits({Codec::h264, Codec::hevc, Codec::prores})},
    Container{".mkv", "matroska",
              bits({Codec::h264, Codec::hevc, Codec::av1, Codec::vp9, Codec::prores, Codec::ffv1})},
    Container{".webm", "webm", bits({Codec::vp9, Codec::av1})},
};

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
    std::string text;
    for (const CodecInfo& codec : codecs()) {
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

}  // namespace carom::pipeline
