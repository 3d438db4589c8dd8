#include "tests/pipeline/video/decoded_video.h"

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/mastering_display_metadata.h>
#include <libavutil/pixdesc.h>
#include <libswscale/swscale.h>
}

#include <memory>
#include <stdexcept>

namespace carom::testing {

namespace {

struct Deleter {
    void operator()(AVFormatContext* context) const { avformat_close_input(&context); }
    void operator()(AVCodecContext* context) const { avcodec_free_context(&context); }
    void operator()(AVFrame* frame) const { av_frame_free(&frame); }
    void operator()(AVPacket* packet) const { av_packet_free(&packet); }
    void operator()(SwsContext* context) const { sws_freeContext(context); }
};
template <class T>
using Ptr = std::unique_ptr<T, Deleter>;

void require(bool good, const char* what) {
    if (!good) {
        throw std::runtime_error(what);
    }
}

std::string text(const char* name) {
    return name == nullptr ? "" : name;
}

std::vector<std::vector<std::uint8_t>> copy_planes(const AVFrame& frame) {
    const auto format = static_cast<AVPixelFormat>(frame.format);
    const AVPixFmtDescriptor& description = *av_pix_fmt_desc_get(format);
    std::vector<std::vector<std::uint8_t>> planes;
    for (int i = 0; i < av_pix_fmt_count_planes(format); ++i) {
        const bool chroma = (i == 1 || i == 2) && (description.flags & AV_PIX_FMT_FLAG_RGB) == 0;
        const int rows = chroma ? frame.height >> description.log2_chroma_h : frame.height;
        const int columns = chroma ? frame.width >> description.log2_chroma_w : frame.width;
        const int bytes = columns * description.comp[0].step;
        std::vector<std::uint8_t> plane;
        for (int row = 0; row < rows; ++row) {
            const std::uint8_t* begin = frame.data[i] + row * frame.linesize[i];
            plane.insert(plane.end(), begin, begin + bytes);
        }
        planes.push_back(std::move(plane));
    }
    return planes;
}

std::vector<std::uint16_t> to_rgb(const AVFrame& frame) {
    const Ptr<SwsContext> scaler(sws_getContext(
        frame.width, frame.height, static_cast<AVPixelFormat>(frame.format), frame.width,
        frame.height, AV_PIX_FMT_RGB48LE, SWS_BICUBIC | SWS_ACCURATE_RND | SWS_FULL_CHR_H_INT,
        nullptr, nullptr, nullptr));
    require(scaler != nullptr, "no scaler");
    const int* matrix =
        sws_getCoefficients(frame.colorspace == AVCOL_SPC_BT2020_NCL ? SWS_CS_BT2020
                            : frame.colorspace == AVCOL_SPC_BT470BG  ? SWS_CS_ITU601
                                                                     : SWS_CS_ITU709);
    sws_setColorspaceDetails(scaler.get(), matrix, frame.color_range == AVCOL_RANGE_JPEG ? 1 : 0,
                             matrix, 1, 0, 1 << 16, 1 << 16);
    std::vector<std::uint16_t> rgb(static_cast<std::size_t>(frame.width) *
                                   static_cast<std::size_t>(frame.height) * 3);
    void* start = rgb.data();
    std::uint8_t* data[] = {static_cast<std::uint8_t*>(start)};
    const int stride[] = {frame.width * 6};
    sws_scale(scaler.get(), frame.data, frame.linesize, 0, frame.height, data, stride);
    return rgb;
}

void describe(const AVStream& stream, DecodedVideo& video) {
    const AVCodecParameters& parameters = *stream.codecpar;
    video.width = parameters.width;
    video.height = parameters.height;
    video.codec = text(avcodec_get_name(parameters.codec_id));
    video.profile = text(avcodec_profile_name(parameters.codec_id, parameters.profile));
    video.pixel_format = text(av_get_pix_fmt_name(static_cast<AVPixelFormat>(parameters.format)));
    video.primaries = text(av_color_primaries_name(parameters.color_primaries));
    video.transfer = text(av_color_transfer_name(parameters.color_trc));
    video.matrix = text(av_color_space_name(parameters.color_space));
    video.range = text(av_color_range_name(parameters.color_range));
    video.chroma_location = text(av_chroma_location_name(parameters.chroma_location));
    video.rate_numerator = stream.avg_frame_rate.num;
    video.rate_denominator = stream.avg_frame_rate.den;
    video.time_base_numerator = stream.time_base.num;
    video.time_base_denominator = stream.time_base.den;
    video.start_time = stream.start_time;
    for (unsigned tag = parameters.codec_tag; tag != 0; tag >>= 8U) {
        video.tag += static_cast<char>(tag & 255U);
    }
    const void* display =
        av_stream_get_side_data(&stream, AV_PKT_DATA_MASTERING_DISPLAY_METADATA, nullptr);
    if (display != nullptr) {
        video.peak = av_q2d(static_cast<const AVMasteringDisplayMetadata*>(display)->max_luminance);
    }
    const void* light = av_stream_get_side_data(&stream, AV_PKT_DATA_CONTENT_LIGHT_LEVEL, nullptr);
    if (light != nullptr) {
        const auto& levels = *static_cast<const AVContentLightMetadata*>(light);
        video.max_light = static_cast<int>(levels.MaxCLL);
        video.max_mean_light = static_cast<int>(levels.MaxFALL);
    }
}

void receive(AVCodecContext& decoder, AVFrame& frame, DecodedVideo& video) {
    while (avcodec_receive_frame(&decoder, &frame) == 0) {
        video.frames.push_back({frame.best_effort_timestamp, frame.pkt_duration,
                                frame.key_frame != 0, copy_planes(frame), to_rgb(frame)});
        av_frame_unref(&frame);
    }
}

}  // namespace

DecodedVideo decode_video(const std::string& path) {
    AVFormatContext* opened = nullptr;
    require(avformat_open_input(&opened, ("file:" + path).c_str(), nullptr, nullptr) == 0,
            "cannot open the video");
    const Ptr<AVFormatContext> container(opened);
    require(avformat_find_stream_info(container.get(), nullptr) >= 0, "no stream information");
    DecodedVideo video;
    for (unsigned i = 1; i < container->nb_streams; ++i) {
        const AVStream& other = *container->streams[i];
        if (other.codecpar->codec_type == AVMEDIA_TYPE_AUDIO) {
            continue;  // decoded_sound.h reads it
        }
        require((other.disposition & AV_DISPOSITION_ATTACHED_PIC) != 0, "a second stream");
        const AVPacket& jpeg = other.attached_pic;
        video.poster.assign(jpeg.data, jpeg.data + jpeg.size);
    }
    const AVStream& stream = *container->streams[0];
    describe(stream, video);
    video.duration = static_cast<double>(container->duration) / AV_TIME_BASE;
    for (const AVDictionaryEntry* tag = nullptr;
         (tag = av_dict_get(container->metadata, "", tag, AV_DICT_IGNORE_SUFFIX)) != nullptr;) {
        video.metadata[tag->key] = tag->value;
    }

    const AVCodec* codec = avcodec_find_decoder(stream.codecpar->codec_id);
    const Ptr<AVCodecContext> decoder(avcodec_alloc_context3(codec));
    require(avcodec_parameters_to_context(decoder.get(), stream.codecpar) >= 0, "bad parameters");
    decoder->thread_count = 1;
    require(avcodec_open2(decoder.get(), codec, nullptr) == 0, "cannot open the decoder");
    const Ptr<AVPacket> packet(av_packet_alloc());
    const Ptr<AVFrame> frame(av_frame_alloc());
    while (av_read_frame(container.get(), packet.get()) == 0) {
        if (packet->stream_index != 0) {
            av_packet_unref(packet.get());
            continue;
        }
        require(avcodec_send_packet(decoder.get(), packet.get()) == 0, "cannot decode");
        av_packet_unref(packet.get());
        receive(*decoder, *frame, video);
    }
    avcodec_send_packet(decoder.get(), nullptr);
    receive(*decoder, *frame, video);
    return video;
}

}  // namespace carom::testing
