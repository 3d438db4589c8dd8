#include "pipeline/video/codec_info.h"

#include <array>

#include "core/assert.h"
#include "pipeline/video/container.h"

namespace carom::pipeline {

namespace {

// The default qualities look alike: each gives a PSNR of about 45 dB on
// examples/nine_ball_break.yaml.
constexpr std::array kCodecs{
    CodecInfo{Codec::h264, "h264", ".mp4", "libx264", 8, true, 18, 51, true, true, true},
    CodecInfo{Codec::hevc, "hevc", ".mp4", "libx265", 8, true, 20, 51, true, true, true},
    CodecInfo{Codec::av1, "av1", ".mp4", "libaom-av1", 8, true, 24, 63, true, true, true},
    CodecInfo{Codec::vp9, "vp9", ".webm", "libvpx-vp9", 8, true, 24, 63, true, true, true},
    CodecInfo{.codec = Codec::prores,
              .name = "prores",
              .extension = ".mov",
              .encoder = "prores_ks",
              .bits = 10,
              .halves_width = true,
              .is_intra_only = true},
    CodecInfo{.codec = Codec::ffv1,
              .name = "ffv1",
              .extension = ".mkv",
              .encoder = "ffv1",
              .bits = 16,
              .is_intra_only = true},
    CodecInfo{.codec = Codec::mjpeg,
              .name = "mjpeg",
              .extension = ".avi",
              .encoder = "mjpeg",
              .is_intra_only = true},
    CodecInfo{.codec = Codec::uncompressed,
              .name = "uncompressed",
              .extension = ".avi",
              .encoder = "rawvideo",
              .is_intra_only = true},
};

}  // namespace

std::span<const CodecInfo> codecs() {
    return kCodecs;
}

const CodecInfo& info(Codec codec) {
    const auto index = static_cast<std::size_t>(codec);
    CAROM_ASSERT(index < kCodecs.size() && kCodecs[index].codec == codec);
    return kCodecs[index];
}

std::string to_string(Codec codec) {
    return std::string(info(codec).name);
}

Codec codec_for(const OutputSettings& output, const std::string& path) {
    if (output.codec) {
        return *output.codec;
    }
    if (output.hdr10) {
        return Codec::hevc;
    }
    const Container* container = find_container(path);
    return container != nullptr ? container->video : Codec::h264;
}

int bits_of(const OutputSettings& output, Codec codec) {
    return output.bits.value_or(output.hdr10 ? 10 : info(codec).bits);
}

}  // namespace carom::pipeline
