#include "pipeline/video/encoder.h"

#include <algorithm>
#include <cmath>

#include "pipeline/video/yuv_conversion.h"
#include "sim/timeline/assert.h"
#include "sim/timeline/error.h"

namespace carom::pipeline {

namespace {

// A key frame at least every two seconds, for scrubbing; costs a still picture about 3 % of size.
constexpr double kSecondsBetweenKeyFrames = 2;

// FFV1 splits pictures into slices that are coded by themselves. Fixed, so that the bytes do not
// follow the number of threads.
constexpr int kFfv1Slices = 4;

const AVCodec* find_encoder(Codec codec, const std::string& path) {
    const char* name = codec == Codec::h264 ? "libx264" : "ffv1";
    const AVCodec* encoder = avcodec_find_encoder_by_name(name);
    if (encoder == nullptr) {
        throw Error("cannot write '" + path + "': this system's libavcodec has no encoder '" +
                    name + "'");
    }
    return encoder;
}

void set_option(AVCodecContext& context, const char* name, const std::string& value,
                const std::string& path) {
    check_av(av_opt_set(context.priv_data, name, value.c_str(), 0), name, path);
}

void set_common(AVCodecContext& context, const VideoFormat& format, const OutputSettings& output) {
    const AVRational rate{static_cast<int>(format.fps.numerator()),
                          static_cast<int>(format.fps.denominator())};
    context.width = format.width;
    context.height = format.height;
    context.sample_aspect_ratio = AVRational{1, 1};
    context.time_base = av_inv_q(rate);
    context.framerate = rate;
    context.thread_count = output.threads;
    context.flags |= AV_CODEC_FLAG_BITEXACT;  // no version of ours in the stream
    context.color_primaries = AVCOL_PRI_BT709;
}

/// The transfer characteristic is tagged as BT.709's, though the signal was encoded with sRGB's
/// curve: video players give the code values of a BT.709 film to the screen as they are, so that
/// the film looks as its frames do in an image viewer, whereas the tag iec61966-2-1 makes some of
/// them convert to another curve and some hosts refuse the file.
void set_h264(AVCodecContext& context, const OutputSettings& output, const std::string& path) {
    context.pix_fmt = AV_PIX_FMT_YUV420P;
    context.color_trc = AVCOL_TRC_BT709;
    context.colorspace = AVCOL_SPC_BT709;
    context.color_range = AVCOL_RANGE_MPEG;
    context.chroma_sample_location = AVCHROMA_LOC_LEFT;  // as yuv_conversion.h places it
    const double gop = kSecondsBetweenKeyFrames * av_q2d(context.framerate);
    context.gop_size = static_cast<int>(std::clamp(std::round(gop), 1.0, 1000.0));
    set_option(context, "preset", output.preset, path);
    // High cannot be lossless: x264 wants High 4:4:4 Predictive for crf 0.
    if (output.crf > 0) {
        set_option(context, "profile", "high", path);
    }
    check_av(av_opt_set_double(context.priv_data, "crf", output.crf, 0), "crf", path);
    // With its AVX-512 code x264 0.164 decides by memory that nobody wrote (at 192 x 108 and
    // 960 x 540 among others): the same frames give other bytes from run to run. Its AVX2 code does
    // not, and gives every machine the same film.
    if (__builtin_cpu_supports("avx2") != 0) {
        set_option(context, "x264-params", "asm=avx2", path);
    }
}

/// The 16-bit RGB that the view transform made, without loss: an archive or an intermediate.
void set_ffv1(AVCodecContext& context, const std::string& path) {
    context.pix_fmt = AV_PIX_FMT_GBRP16;
    context.color_trc = AVCOL_TRC_IEC61966_2_1;
    context.colorspace = AVCOL_SPC_RGB;
    context.color_range = AVCOL_RANGE_JPEG;
    context.gop_size = 1;  // every frame stands alone
    context.level = 3;
    context.slices = kFfv1Slices;
    set_option(context, "slicecrc", "1", path);
}

template <class T>
PlaneView<T> plane(AVFrame& frame, int index) {
    void* data = frame.data[index];
    return {static_cast<T*>(data), frame.linesize[index] / static_cast<int>(sizeof(T))};
}

}  // namespace

AvPtr<AVCodecContext> open_encoder(const VideoFormat& format, const OutputSettings& output,
                                   bool global_header, const std::string& path) {
    const AVCodec* encoder = find_encoder(output.codec, path);
    AvPtr<AVCodecContext> context(check_allocated(avcodec_alloc_context3(encoder), path));
    set_common(*context, format, output);
    if (global_header) {
        context->flags |= AV_CODEC_FLAG_GLOBAL_HEADER;
    }
    switch (output.codec) {
        case Codec::h264:
            set_h264(*context, output, path);
            break;
        case Codec::ffv1:
            set_ffv1(*context, path);
            break;
    }
    check_av(avcodec_open2(context.get(), encoder, nullptr), "opening the encoder", path);
    return context;
}

void fill_frame(AVFrame& frame, std::span<const std::uint16_t> rgb) {
    if (frame.format == AV_PIX_FMT_YUV420P) {
        convert_to_yuv420(rgb, frame.width, frame.height, plane<std::uint8_t>(frame, 0),
                          plane<std::uint8_t>(frame, 1), plane<std::uint8_t>(frame, 2));
    } else {
        CAROM_ASSERT(frame.format == AV_PIX_FMT_GBRP16);
        split_channels(rgb, frame.width, frame.height, plane<std::uint16_t>(frame, 2),
                       plane<std::uint16_t>(frame, 0), plane<std::uint16_t>(frame, 1));
    }
}

}  // namespace carom::pipeline
