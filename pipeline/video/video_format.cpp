#include "pipeline/video/video_format.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <string_view>

#include "pipeline/video/container.h"

namespace carom::pipeline {

namespace {

// H.264 level 6.2 ends at 139264 macroblocks and 16864 pixels a side (ITU-T H.264, table A-1 and
// A.3.1 h); MP4's track header holds 16 bits a side.
constexpr int kLargestSide = 16384;
constexpr std::int64_t kMostMacroblocks = 139264;
constexpr int kSmallestSide = 16;

// H.264 states the rate as time_scale / (2 num_units_in_tick), both 32-bit (E.2.1), and libav keeps
// fractions in signed ints.
constexpr std::int64_t kLargestRateTerm = std::int64_t{1} << 30;
constexpr double kFastestRate = 1000;

constexpr int kMostThreads = 64;

constexpr std::array<std::string_view, 10> kPresets{"ultrafast", "superfast", "veryfast", "faster",
                                                    "fast",      "medium",    "slow",     "slower",
                                                    "veryslow",  "placebo"};

std::string size_text(std::int64_t width, std::int64_t height) {
    return std::to_string(width) + "x" + std::to_string(height);
}

/// The even numbers next to `side`: itself, or both neighbours of an odd one.
int even_below(int side) {
    return side - side % 2;
}
int even_above(int side) {
    return side + side % 2;
}

std::string check_size(const VideoFormat& format, Codec codec) {
    const int width = format.width;
    const int height = format.height;
    const std::string size = size_text(width, height);
    if (width < kSmallestSide || height < kSmallestSide || width > kLargestSide ||
        height > kLargestSide) {
        return "a film of " + size + " pixels cannot be written: each side must be from " +
               std::to_string(kSmallestSide) + " to " + std::to_string(kLargestSide);
    }
    if (codec != Codec::h264) {
        return {};
    }
    if (width % 2 != 0 || height % 2 != 0) {
        return "h264 with 4:2:0 colour needs even sizes, not " + size + "; the nearest are " +
               size_text(even_below(width), even_below(height)) + " and " +
               size_text(even_above(width), even_above(height));
    }
    const std::int64_t macroblocks = std::int64_t{(width + 15) / 16} * ((height + 15) / 16);
    if (macroblocks > kMostMacroblocks) {
        return "h264 cannot hold pictures of " + size +
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

std::string check_encoder(const OutputSettings& output) {
    if (!(output.crf >= 0 && output.crf <= 51)) {
        return "crf must be from 0 (lossless) to 51 (worst)";
    }
    if (output.threads < 1 || output.threads > kMostThreads) {
        return "the encoder's threads must be from 1 to " + std::to_string(kMostThreads) +
               ", not " + std::to_string(output.threads);
    }
    if (std::find(kPresets.begin(), kPresets.end(), output.preset) == kPresets.end()) {
        std::string text = "unknown encoder preset '" + output.preset + "'; there are ";
        for (std::size_t i = 0; i < kPresets.size(); ++i) {
            text += (i == 0 ? "" : ", ") + std::string(kPresets[i]);
        }
        return text;
    }
    return {};
}

std::string check_path(Codec codec, const std::string& path) {
    const Container* container = find_container(path);
    const std::string extension = std::filesystem::path(path).extension().string();
    if (container == nullptr) {
        return "cannot tell what film to write from '" + path + "'" +
               (extension.empty() ? ", which has no extension" : "") + "; there are " +
               list_containers();
    }
    if (!container->holds(codec)) {
        return extension + " files cannot hold " + to_string(codec) + "; there are " +
               list_containers();
    }
    return {};
}

}  // namespace

std::string check_video_format(const VideoFormat& format, const OutputSettings& output,
                               const std::string& path) {
    std::string problem = check_path(output.codec, path);
    if (problem.empty()) {
        problem = check_size(format, output.codec);
    }
    if (problem.empty()) {
        problem = check_rate(format.fps);
    }
    if (problem.empty()) {
        problem = check_encoder(output);
    }
    return problem;
}

std::string default_extension(Codec codec) {
    return codec == Codec::h264 ? ".mp4" : ".mkv";
}

std::string to_string(Codec codec) {
    return codec == Codec::h264 ? "h264" : "ffv1";
}

}  // namespace carom::pipeline
