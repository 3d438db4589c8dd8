// Reads a video with libav's demuxer and decoder, independently of the code under test.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace carom::testing {

struct DecodedFrame {
    std::int64_t pts = 0;  // in the stream's time base
    std::int64_t duration = 0;
    bool key = false;
    /// The decoder's planes, tightly packed, in its own order (Y Cb Cr, or G B R).
    std::vector<std::vector<std::uint8_t>> planes;
    /// The picture as 16-bit RGB, by swscale with the matrix and range that the file's tags name.
    std::vector<std::uint16_t> rgb;
};

struct DecodedVideo {
    int width = 0;
    int height = 0;
    std::string codec, profile, pixel_format;
    std::string primaries, transfer, matrix, range, chroma_location;
    int rate_numerator = 0, rate_denominator = 0;            // average frame rate
    int time_base_numerator = 0, time_base_denominator = 0;  // of the stream
    std::int64_t start_time = 0;                             // of the stream
    double duration = 0;                                     // of the container, s
    std::string tag;                                         // the codec's tag in the container
    double peak = 0;                                         // of the mastering display, cd/m^2
    int max_light = 0;                                       // MaxCLL, cd/m^2
    int max_mean_light = 0;                                  // MaxFALL, cd/m^2
    std::vector<std::uint8_t> poster;                        // the attached JPEG
    std::map<std::string, std::string> metadata;
    std::vector<DecodedFrame> frames;  // in order of presentation
};

/// Throws std::runtime_error.
[[nodiscard]] DecodedVideo decode_video(const std::string& path);

}  // namespace carom::testing
