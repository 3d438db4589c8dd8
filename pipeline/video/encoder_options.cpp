#include "pipeline/video/encoder_options.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include <fmt/core.h>

#include "pipeline/video/codec_info.h"
#include "pipeline/video/encoder_presets.h"

namespace carom::pipeline {

namespace {

// A key frame at least every two seconds, for scrubbing. For a static picture this adds about 3 %
// to the size.
constexpr double kSecondsBetweenKeyFrames = 2;

// FFV1 splits pictures into slices that are coded independently. Their number is fixed, so that the
// bytes do not depend on the number of threads.
constexpr int kFfv1Slices = 4;

constexpr int kProresHq = 3;  // the number of profile 422 HQ in prores_ks

void set_option(AVCodecContext& context, const char* name, const std::string& value,
                const std::string& path) {
    check_av(av_opt_set(context.priv_data, name, value.c_str(), 0), name, path);
}

void set_option(AVCodecContext& context, const char* name, double value, const std::string& path) {
    check_av(av_opt_set_double(context.priv_data, name, value, 0), name, path);
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
    context.flags |= AV_CODEC_FLAG_BITEXACT;  // no version of libav in the stream
    const double gop = kSecondsBetweenKeyFrames * format.fps.to_double();
    context.gop_size = static_cast<int>(std::clamp(std::round(gop), 1.0, 1000.0));
}

/// The transfer characteristic is tagged as BT.709, although the signal was encoded with the sRGB
/// curve. Video players send the code values of a BT.709 film to the screen unchanged, so the film
/// looks the same as its frames in an image viewer. With the tag iec61966-2-1 some players convert
/// to another curve, and some video sites refuse the file.
void set_colour(AVCodecContext& context, const OutputSettings& output) {
    context.color_primaries = output.hdr10 ? AVCOL_PRI_BT2020 : AVCOL_PRI_BT709;
    context.color_trc = output.hdr10 ? AVCOL_TRC_SMPTE2084 : AVCOL_TRC_BT709;
    context.colorspace = output.hdr10 ? AVCOL_SPC_BT2020_NCL : AVCOL_SPC_BT709;
    context.color_range = AVCOL_RANGE_MPEG;
    context.chroma_sample_location = AVCHROMA_LOC_LEFT;  // the siting of yuv_conversion.h
}

/// Sets the quality or the bit rate. `crf` is a private option of the encoder.
void set_quality(AVCodecContext& context, Codec codec, const OutputSettings& output,
                 const std::string& path) {
    if (output.bit_rate) {
        context.bit_rate = static_cast<std::int64_t>(std::llround(*output.bit_rate));
        return;
    }
    set_option(context, "crf", output.crf.value_or(info(codec).crf), path);
}

void set_h264(AVCodecContext& context, const OutputSettings& output, const std::string& path) {
    const bool ten_bits = bits_of(output, Codec::h264) == 10;
    context.pix_fmt = ten_bits ? AV_PIX_FMT_YUV420P10 : AV_PIX_FMT_YUV420P;
    set_option(context, "preset", output.preset, path);
    // These profiles cannot be lossless: x264 needs High 4:4:4 Predictive for crf 0.
    if (output.bit_rate || output.crf.value_or(info(Codec::h264).crf) > 0) {
        set_option(context, "profile", ten_bits ? "high10" : "high", path);
    }
    // The AVX-512 code of x264 0.164 reads uninitialised memory (at 192 x 108 and 960 x 540, among
    // others), so that the same frames give different bytes from run to run. Its AVX2 code does
    // not, and gives the same film on every machine.
    if (__builtin_cpu_supports("avx2") != 0) {
        set_option(context, "x264-params", "asm=avx2", path);
    }
}

/// x265 has two settings for threads: the size of its pool does not change the bytes, the number of
/// frames that are coded at the same time does. By default it also prints messages and writes its
/// version and settings into the stream; both are switched off.
void set_hevc(AVCodecContext& context, const VideoFormat& format, const OutputSettings& output,
              const std::string& path) {
    const bool ten_bits = bits_of(output, Codec::hevc) == 10;
    context.pix_fmt = ten_bits ? AV_PIX_FMT_YUV420P10 : AV_PIX_FMT_YUV420P;
    set_option(context, "preset", output.preset, path);
    set_option(context, "profile", ten_bits ? "main10" : "main", path);
    std::string parameters = fmt::format("log-level=none:info=0:pools={}:frame-threads={}",
                                         output.threads, std::min(output.threads, 16));
    if (std::min(context.width, context.height) < 64) {
        parameters += ":ctu=16:max-tu-size=16";  // the picture must be at least one block large
    }
    // Its look-ahead works on blocks of 16 x 16 pixels, and its vector code for trees of coding
    // units (estimateCUPropagate) on four of them: x265 3.5 writes beyond the end of a row of
    // three, which ends the process.
    if (context.width <= 48) {
        parameters += ":cutree=0";
    }
    if (output.hdr10) {
        parameters += ":" + x265_hdr10(*output.hdr10, light_levels(format, *output.hdr10));
    }
    set_option(context, "x265-params", parameters, path);
}

void set_av1(AVCodecContext& context, const OutputSettings& output, const std::string& path) {
    const bool ten_bits = bits_of(output, Codec::av1) == 10;
    context.pix_fmt = ten_bits ? AV_PIX_FMT_YUV420P10 : AV_PIX_FMT_YUV420P;
    set_option(context, "cpu-used", presets_of(output.preset).av1, path);
    set_option(context, "row-mt", 1, path);
}

void set_vp9(AVCodecContext& context, const OutputSettings& output, const std::string& path) {
    const bool ten_bits = bits_of(output, Codec::vp9) == 10;
    context.pix_fmt = ten_bits ? AV_PIX_FMT_YUV420P10 : AV_PIX_FMT_YUV420P;
    context.profile = ten_bits ? FF_PROFILE_VP9_2 : FF_PROFILE_VP9_0;
    set_option(context, "deadline", "good", path);
    set_option(context, "cpu-used", presets_of(output.preset).vp9, path);
    set_option(context, "row-mt", 1, path);
}

void set_prores(AVCodecContext& context, const std::string& path) {
    context.pix_fmt = AV_PIX_FMT_YUV422P10;
    context.gop_size = 1;
    set_option(context, "profile", kProresHq, path);
    set_option(context, "vendor", "apl0", path);  // some editors accept no other value
}

/// Lossless 16-bit RGB as the view transform made it, for archives and intermediate files.
void set_ffv1(AVCodecContext& context, const std::string& path) {
    context.pix_fmt = AV_PIX_FMT_GBRP16;
    context.color_trc = AVCOL_TRC_IEC61966_2_1;
    context.colorspace = AVCOL_SPC_RGB;
    context.color_range = AVCOL_RANGE_JPEG;
    context.chroma_sample_location = AVCHROMA_LOC_UNSPECIFIED;
    context.gop_size = 1;  // every frame is a key frame
    context.level = 3;
    context.slices = kFfv1Slices;
    set_option(context, "slicecrc", "1", path);
}

/// JPEG's colour: that of ITU-R BT.601 in full range (ITU-T T.871), at every pixel. Quantisers of
/// 2, the finest of the encoder's scale but one, give a PSNR of about 47 dB.
void set_mjpeg(AVCodecContext& context) {
    constexpr int kQuantiser = 2;
    context.pix_fmt = AV_PIX_FMT_YUVJ444P;
    context.color_trc = AVCOL_TRC_IEC61966_2_1;
    context.colorspace = AVCOL_SPC_BT470BG;
    context.color_range = AVCOL_RANGE_JPEG;
    context.chroma_sample_location = AVCHROMA_LOC_UNSPECIFIED;
    context.gop_size = 1;
    context.flags |= AV_CODEC_FLAG_QSCALE;
    context.global_quality = kQuantiser * FF_QP2LAMBDA;
    context.thread_type = FF_THREAD_FRAME;  // slices would put other bytes into the file
}

void set_uncompressed(AVCodecContext& context) {
    context.pix_fmt = AV_PIX_FMT_BGR24;
    context.color_trc = AVCOL_TRC_IEC61966_2_1;
    context.colorspace = AVCOL_SPC_RGB;
    context.color_range = AVCOL_RANGE_JPEG;
    context.chroma_sample_location = AVCHROMA_LOC_UNSPECIFIED;
}

}  // namespace

void set_encoder_options(AVCodecContext& context, Codec codec, const VideoFormat& format,
                         const OutputSettings& output, const std::string& path) {
    set_common(context, format, output);
    set_colour(context, output);
    if (info(codec).worst_crf > 0) {
        set_quality(context, codec, output, path);
    }
    switch (codec) {
        case Codec::h264:
            set_h264(context, output, path);
            break;
        case Codec::hevc:
            set_hevc(context, format, output, path);
            break;
        case Codec::av1:
            set_av1(context, output, path);
            break;
        case Codec::vp9:
            set_vp9(context, output, path);
            break;
        case Codec::prores:
            set_prores(context, path);
            break;
        case Codec::ffv1:
            set_ffv1(context, path);
            break;
        case Codec::mjpeg:
            set_mjpeg(context);
            break;
        case Codec::uncompressed:
            set_uncompressed(context);
            break;
    }
}

/// SMPTE ST 2086 in steps of 0.00002 and 0.0001 cd/m^2: a display with P3 primaries, D65 white, and
/// luminances from 0.005 cd/m^2 to the peak.
std::string x265_hdr10(const Hdr10Settings& settings, const LightLevels& light) {
    const auto peak = std::llround(settings.peak);
    return fmt::format(
        "hdr10=1:hdr10-opt=1:master-display=G(13250,34500)B(7500,3000)R(34000,16000)WP(15635,16450)"
        "L({},50):max-cll={},{}",
        peak * 10000, light.brightest, light.brightest_mean);
}

LightLevels light_levels(const VideoFormat& format, const Hdr10Settings& settings) {
    return format.light.value_or(LightLevels{static_cast<int>(std::lround(settings.peak)), 0});
}

}  // namespace carom::pipeline
