#include "pipeline/video/encoder.h"

#include "core/assert.h"
#include "core/error.h"
#include "pipeline/video/codec_info.h"
#include "pipeline/video/encoder_options.h"
#include "pipeline/video/yuv_conversion.h"

namespace carom::pipeline {

namespace {

// The number of frames by which x265 delays decoding, because every preset has a pyramid of B
// frames.
constexpr std::int64_t kX265Delay = 2;

const AVCodec* find_encoder(Codec codec, const std::string& path) {
    const std::string name(info(codec).encoder);
    const AVCodec* encoder = avcodec_find_encoder_by_name(name.c_str());
    if (encoder == nullptr) {
        throw Error("cannot write '" + path + "': this system's libavcodec has no encoder '" +
                    name + "'");
    }
    return encoder;
}

template <class T>
PlaneView<T> plane(AVFrame& frame, int index) {
    void* data = frame.data[index];
    return {static_cast<T*>(data), frame.linesize[index] / static_cast<int>(sizeof(T))};
}

template <class T>
YuvPlanes<T> yuv_planes(AVFrame& frame) {
    return {plane<T>(frame, 0), plane<T>(frame, 1), plane<T>(frame, 2)};
}

}  // namespace

AvPtr<AVCodecContext> open_encoder(const VideoFormat& format, const OutputSettings& output,
                                   bool global_header, const std::string& path) {
    const Codec codec = codec_for(output, path);
    const AVCodec* encoder = find_encoder(codec, path);
    AvPtr<AVCodecContext> context(check_allocated(avcodec_alloc_context3(encoder), path));
    set_encoder_options(*context, codec, format, output, path);
    if (global_header) {
        context->flags |= AV_CODEC_FLAG_GLOBAL_HEADER;
    }
    check_av(avcodec_open2(context.get(), encoder, nullptr), "opening the encoder", path);
    return context;
}

void set_decoding_time(AVPacket& packet, const AVCodecContext& encoder, std::int64_t index) {
    if (encoder.codec_id == AV_CODEC_ID_HEVC) {
        packet.dts = index - kX265Delay;
    }
}

void fill_frame(AVFrame& frame, std::span<const std::uint16_t> rgb) {
    YuvCoding coding;
    coding.bt2020 = frame.colorspace == AVCOL_SPC_BT2020_NCL;
    switch (frame.format) {
        case AV_PIX_FMT_YUV420P:
            convert_to_yuv420(rgb, frame.width, frame.height, yuv_planes<std::uint8_t>(frame));
            return;
        case AV_PIX_FMT_YUV422P10:
            coding.halve_height = false;
            [[fallthrough]];
        case AV_PIX_FMT_YUV420P10:
            convert_to_yuv10(rgb, frame.width, frame.height, coding,
                             yuv_planes<std::uint16_t>(frame));
            return;
        case AV_PIX_FMT_YUVJ444P:
            convert_to_jpeg_yuv(rgb, frame.width, frame.height, yuv_planes<std::uint8_t>(frame));
            return;
        case AV_PIX_FMT_BGR24:
            convert_to_bgr24(rgb, frame.width, frame.height, plane<std::uint8_t>(frame, 0));
            return;
        default:
            CAROM_ASSERT(frame.format == AV_PIX_FMT_GBRP16);
            split_channels(rgb, frame.width, frame.height, plane<std::uint16_t>(frame, 2),
                           plane<std::uint16_t>(frame, 0), plane<std::uint16_t>(frame, 1));
    }
}

YuvPlanes<std::uint16_t> yuv10_planes(AVFrame& frame) {
    CAROM_ASSERT(frame.format == AV_PIX_FMT_YUV420P10 || frame.format == AV_PIX_FMT_YUV422P10);
    return yuv_planes<std::uint16_t>(frame);
}

}  // namespace carom::pipeline
