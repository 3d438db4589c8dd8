#include "pipeline/video/video_format.h"

#include <cstdint>
#include <filesystem>
#include <string>

#include <fmt/core.h>

#include "pipeline/video/audio_codec_info.h"
#include "pipeline/video/codec_info.h"
#include "pipeline/video/container.h"
#include "pipeline/video/encoder_presets.h"
#include "pipeline/video/image_sequence.h"
#include "pipeline/video/picture_kind.h"

namespace carom::pipeline {

namespace {

// H.264 level 6.2 allows 139264 macroblocks and 16864 pixels per side (ITU-T H.264, table A-1 and
// A.3.1 h), and the highest levels of HEVC, VP9 and AV1 allow as many pixels. MP4's track header
// has 16 bits per side.
constexpr int kLargestSide = 16384;
constexpr std::int64_t kMostMacroblocks = 139264;
constexpr int kSmallestSide = 16;

// H.264 states the rate as time_scale / (2 num_units_in_tick), both 32-bit (E.2.1), and libav
// stores fractions as signed ints.
constexpr std::int64_t kLargestRateTerm = std::int64_t{1} << 30;
constexpr double kFastestRate = 1000;

constexpr int kMostThreads = 64;

constexpr double kLeastBitRate = 1e4;
constexpr double kMostBitRate = 1e9;

std::string size_text(std::int64_t width, std::int64_t height) {
    return fmt::format("{}x{}", width, height);
}

std::string check_size(const VideoFormat& format, Codec codec) {
    const int width = format.width;
    const int height = format.height;
    const std::string size = size_text(width, height);
    if (width < kSmallestSide || height < kSmallestSide || width > kLargestSide ||
        height > kLargestSide) {
        return fmt::format("a film of {} pixels cannot be written: each side must be from {} to {}",
                           size, kSmallestSide, kLargestSide);
    }
    const CodecInfo& limits = info(codec);
    const int even_width = limits.halves_width ? width % 2 : 0;
    const int even_height = limits.halves_height ? height % 2 : 0;
    if (even_width != 0 || even_height != 0) {
        return to_string(codec) + " with " + (limits.halves_height ? "4:2:0" : "4:2:2") +
               " colour needs even " + (limits.halves_height ? "sizes" : "widths") + ", not " +
               size + "; the nearest are " + size_text(width - even_width, height - even_height) +
               " and " + size_text(width + even_width, height + even_height) +
               ", and pictures (film.####.png) or codec ffv1 (.mkv) can have any size";
    }
    const std::int64_t macroblocks = std::int64_t{(width + 15) / 16} * ((height + 15) / 16);
    if (limits.has_levels && macroblocks > kMostMacroblocks) {
        return to_string(codec) + " cannot hold pictures of " + size +
               " pixels (its highest level ends at 35.6 million); use codec ffv1 or a smaller size";
    }
    return {};
}

std::string check_rate(const Rational& fps) {
    if (fps.numerator() < 1 || fps.numerator() > kLargestRateTerm ||
        fps.denominator() > kLargestRateTerm || fps.to_double() > kFastestRate) {
        return "a film of " + fps.to_string() +
               " frames/s cannot be written: the rate must be above 0 and at most 1000, as a "
               "fraction of numbers up to 2^30";
    }
    return {};
}

SettingProblem check_quality(const OutputSettings& output, Codec codec) {
    const CodecInfo& codec_info = info(codec);
    if (codec_info.worst_crf <= 0) {
        return {};  // its quality is fixed; settings for other codecs are ignored
    }
    if (output.crf && output.bit_rate) {
        return {{"crf", "bit_rate"},
                "crf and bit_rate cannot be combined: crf fixes the quality, bit_rate the size"};
    }
    if (output.crf && !(*output.crf >= 0 && *output.crf <= codec_info.worst_crf)) {
        return {{"crf", "codec"},
                fmt::format("crf must be from 0 ({}) to {} (worst)",
                            codec == Codec::hevc ? "best" : "lossless",
                            static_cast<int>(codec_info.worst_crf))};
    }
    if (output.bit_rate &&
        !(*output.bit_rate >= kLeastBitRate && *output.bit_rate <= kMostBitRate)) {
        return {{"bit_rate"}, "bit_rate must be from 10 kbit/s to 1 Gbit/s"};
    }
    return {};
}

SettingProblem check_bits(const OutputSettings& output, Codec codec) {
    if (output.bits && !info(codec).has_choice_of_bits && *output.bits != info(codec).bits) {
        return {{"bits", "codec"},
                fmt::format("{} always has {} bits per channel; leave out 'bits'", to_string(codec),
                            info(codec).bits)};
    }
    if (output.bits && *output.bits != 8 && *output.bits != 10) {
        return {{"bits"}, fmt::format("bits must be 8 or 10, not {}", *output.bits)};
    }
    if (!output.hdr10) {
        return {};
    }
    if (codec != Codec::hevc) {
        return {{"codec", "hdr10"}, "hdr10 is for codec hevc, not " + to_string(codec)};
    }
    if (output.bits == 8) {
        return {{"bits", "hdr10"}, "hdr10 has 10 bits per channel, not 8"};
    }
    if (!(output.hdr10->peak >= 400 && output.hdr10->peak <= 10000 && output.hdr10->white > 0 &&
          output.hdr10->white <= output.hdr10->peak)) {
        return {{"hdr10"},
                "hdr10 needs a peak from 400 to 10000 cd/m^2 and a white above 0 and up to the "
                "peak"};
    }
    return {};
}

SettingProblem check_encoder(const OutputSettings& output) {
    if (output.threads < 1 || output.threads > kMostThreads) {
        return {{"threads"},
                fmt::format("the encoder's threads must be from 1 to {}, not {}", kMostThreads,
                            output.threads)};
    }
    if (find_preset(output.preset) == nullptr) {
        std::string text = "unknown encoder preset '" + output.preset + "'; use one of ";
        for (const EncoderPreset& preset : kEncoderPresets) {
            text += (&preset == kEncoderPresets.data() ? "" : ", ") + std::string(preset.name);
        }
        return {{"preset"}, text};
    }
    return {};
}

/// Paths that are no video file are the concern of check_path.
SettingProblem check_audio(const OutputSettings& output, const std::string& path) {
    const Container* container = find_container(path);
    const AudioCodec codec = audio_codec_for(output, path);
    if (container == nullptr || codec == AudioCodec::none) {
        return {};
    }
    if (!container->holds(codec)) {
        std::string text =
            std::string(container->extension) + " files cannot hold " + to_string(codec) + " sound";
        if (codec == AudioCodec::aac && container->muxer == "matroska") {
            text += ", with which their first picture would be shown 21 ms late";
        }
        return {{"audio", "codec"},
                text + "; the codecs of sound and their file extensions are " +
                    list_audio_containers()};
    }
    if (output.audio_bit_rate && !is_audio_bit_rate(*output.audio_bit_rate)) {
        return {{"audio_bit_rate"}, "audio_bit_rate must be from 32 to 512 kbit/s"};
    }
    return {};
}

/// "shot.####.png" for "shot.png".
std::string sequence_pattern(const std::string& path) {
    const std::filesystem::path given(path);
    const std::string name = given.stem().string() + ".####" + given.extension().string();
    return (given.parent_path() / name).string();
}

std::string check_path(Codec codec, const std::string& path) {
    const Container* container = find_container(path);
    const std::string extension = std::filesystem::path(path).extension().string();
    if (container == nullptr && is_picture_path(path)) {
        return "'" + path +
               "' is a single picture, which cannot hold a film; write one picture per " +
               "frame to '" + sequence_pattern(path) + "', or one frame with 'carom frame'";
    }
    if (container == nullptr) {
        return "'" + path + "' " +
               (extension.empty() ? "has no file extension" : "is not a known type of video file") +
               "; the codecs and their file extensions are " + list_containers();
    }
    if (!container->holds(codec)) {
        return extension + " files cannot hold " + to_string(codec) +
               "; the codecs and their file extensions are " + list_containers();
    }
    return {};
}

}  // namespace

std::string check_film_size(const VideoFormat& format, const OutputSettings& output,
                            const std::string& path) {
    return is_image_sequence(path) ? "" : check_size(format, codec_for(output, path));
}

SettingProblem find_setting_problem(const OutputSettings& output, const std::string& path) {
    const Codec codec = codec_for(output, path);
    SettingProblem problem = check_quality(output, codec);
    if (problem.sentence.empty()) {
        problem = check_bits(output, codec);
    }
    if (problem.sentence.empty()) {
        problem = check_audio(output, path);
    }
    return problem.sentence.empty() ? check_encoder(output) : problem;
}

std::string check_video_format(const VideoFormat& format, const OutputSettings& output,
                               const std::string& path) {
    if (is_image_sequence(path)) {
        return check_image_sequence(path);
    }
    const Codec codec = codec_for(output, path);
    for (const std::string& problem :
         {check_path(codec, path), check_size(format, codec), check_rate(format.fps),
          find_setting_problem(output, path).sentence}) {
        if (!problem.empty()) {
            return problem;
        }
    }
    return {};
}

std::string default_extension(const OutputSettings& output) {
    const Codec codec = codec_for(output, ".mp4");
    const std::string_view usual = info(codec).extension;
    if (!output.audio || find_container("film" + std::string(usual))->holds(*output.audio)) {
        return std::string(usual);
    }
    for (const Container& container : containers()) {
        if (container.holds(codec) && container.holds(*output.audio)) {
            return std::string(container.extension);
        }
    }
    return std::string(usual);  // no file holds both, which find_setting_problem says
}

}  // namespace carom::pipeline
