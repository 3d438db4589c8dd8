#include "pipeline/video/encoded_size.h"

#include "core/assert.h"
#include "core/error.h"
#include "pipeline/video/encoder.h"

namespace carom::pipeline {
namespace {

AvPtr<AVFrame> make_frame(const AVCodecContext& encoder, const std::string& path) {
    AvPtr<AVFrame> frame(check_allocated(av_frame_alloc(), path));
    frame->format = encoder.pix_fmt;
    frame->width = encoder.width;
    frame->height = encoder.height;
    frame->colorspace = encoder.colorspace;
    frame->color_range = encoder.color_range;
    frame->color_primaries = encoder.color_primaries;
    frame->color_trc = encoder.color_trc;
    check_av(av_frame_get_buffer(frame.get(), 0), "allocating a frame", path);
    return frame;
}

/// Sends a picture (or nullptr at the end) and adds the packets that the encoder returns to the
/// sizes of their pictures.
void encode(AVCodecContext& encoder, const AVFrame* picture, std::vector<std::uint64_t>& sizes,
            const std::string& path) {
    const AvPtr<AVPacket> packet(check_allocated(av_packet_alloc(), path));
    check_av(avcodec_send_frame(&encoder, picture), "encoding", path);
    for (;;) {
        const int code = avcodec_receive_packet(&encoder, packet.get());
        if (code == AVERROR(EAGAIN) || code == AVERROR_EOF) {
            return;
        }
        check_av(code, "encoding", path);
        sizes.at(static_cast<std::size_t>(packet->pts)) += static_cast<std::uint64_t>(packet->size);
    }
}

}  // namespace

std::vector<std::uint64_t> encoded_sizes(std::span<const std::vector<std::uint16_t>> pictures,
                                         const VideoFormat& format, const OutputSettings& output,
                                         const std::string& path) {
    const std::string problem = check_video_format(format, output, path);
    if (!problem.empty()) {
        throw Error(problem);
    }
    capture_av_log();
    constexpr bool kGlobalHeader = true;  // so that the first picture does not contain it
    const AvPtr<AVCodecContext> encoder = open_encoder(format, output, kGlobalHeader, path);
    const AvPtr<AVFrame> frame = make_frame(*encoder, path);
    std::vector<std::uint64_t> sizes(pictures.size());
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        CAROM_ASSERT(pictures[i].size() == std::size_t{3} * static_cast<std::size_t>(format.width) *
                                               static_cast<std::size_t>(format.height));
        // If the encoder still refers to the previous picture, this gives the frame a new buffer.
        check_av(av_frame_make_writable(frame.get()), "allocating a frame", path);
        fill_frame(*frame, pictures[i]);
        frame->pts = static_cast<std::int64_t>(i);
        encode(*encoder, frame.get(), sizes, path);
    }
    encode(*encoder, nullptr, sizes, path);
    return sizes;
}

}  // namespace carom::pipeline
