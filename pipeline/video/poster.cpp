#include "pipeline/video/poster.h"

extern "C" {
#include <libswscale/swscale.h>
}

#include "core/assert.h"

namespace carom::pipeline {

namespace {

// The quantiser of mjpeg from 1 (best) to 31; 2 is about JPEG quality 95.
constexpr int kQuantiser = 2;

struct ScalerDeleter {
    void operator()(SwsContext* context) const { sws_freeContext(context); }
};

AvPtr<AVCodecContext> open_jpeg(int width, int height, const std::string& path) {
    const AVCodec* encoder = check_allocated(avcodec_find_encoder(AV_CODEC_ID_MJPEG), path);
    AvPtr<AVCodecContext> context(check_allocated(avcodec_alloc_context3(encoder), path));
    context->width = width;
    context->height = height;
    context->time_base = AVRational{1, 1};
    context->pix_fmt = AV_PIX_FMT_YUVJ420P;
    context->thread_count = 1;
    context->flags |= AV_CODEC_FLAG_BITEXACT | AV_CODEC_FLAG_QSCALE;
    context->global_quality = kQuantiser * FF_QP2LAMBDA;
    check_av(avcodec_open2(context.get(), encoder, nullptr), "opening the poster's encoder", path);
    return context;
}

// JFIF uses BT.601 in full range, and swscale assumes the same of this pixel format.
AvPtr<AVFrame> jpeg_frame(std::span<const std::uint8_t> rgb, int width, int height,
                          const std::string& path) {
    AvPtr<AVFrame> frame(check_allocated(av_frame_alloc(), path));
    frame->format = AV_PIX_FMT_YUVJ420P;
    frame->width = width;
    frame->height = height;
    frame->quality = kQuantiser * FF_QP2LAMBDA;
    check_av(av_frame_get_buffer(frame.get(), 0), "allocating the poster", path);
    const std::unique_ptr<SwsContext, ScalerDeleter> scaler(check_allocated(
        sws_getContext(width, height, AV_PIX_FMT_RGB24, width, height, AV_PIX_FMT_YUVJ420P,
                       SWS_BICUBIC | SWS_ACCURATE_RND | SWS_BITEXACT, nullptr, nullptr, nullptr),
        path));
    const std::uint8_t* source[] = {rgb.data()};
    const int stride[] = {3 * width};
    sws_scale(scaler.get(), source, stride, 0, height, frame->data, frame->linesize);
    return frame;
}

}  // namespace

void describe_poster(AVStream& stream, int width, int height) {
    stream.disposition = AV_DISPOSITION_ATTACHED_PIC;
    stream.time_base = AVRational{1, 1};
    stream.codecpar->codec_type = AVMEDIA_TYPE_VIDEO;
    stream.codecpar->codec_id = AV_CODEC_ID_MJPEG;
    stream.codecpar->width = width;
    stream.codecpar->height = height;
    stream.codecpar->format = AV_PIX_FMT_YUVJ420P;
}

AvPtr<AVPacket> encode_poster(std::span<const std::uint8_t> rgb, int width, int height,
                              const std::string& path) {
    CAROM_ASSERT(rgb.size() == std::size_t{3} * static_cast<std::size_t>(width) *
                                   static_cast<std::size_t>(height));
    const AvPtr<AVCodecContext> encoder = open_jpeg(width, height, path);
    const AvPtr<AVFrame> frame = jpeg_frame(rgb, width, height, path);
    AvPtr<AVPacket> packet(check_allocated(av_packet_alloc(), path));
    check_av(avcodec_send_frame(encoder.get(), frame.get()), "encoding the poster", path);
    check_av(avcodec_receive_packet(encoder.get(), packet.get()), "encoding the poster", path);
    packet->pts = packet->dts = 0;
    packet->duration = 1;
    packet->flags |= AV_PKT_FLAG_KEY;
    return packet;
}

}  // namespace carom::pipeline
