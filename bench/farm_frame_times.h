// The measured times of the frames of a real film, bench/farm_frame_times.csv.
#pragma once

#include <string>
#include <vector>

namespace carom::bench {

/// One row of the file. 0 means that the frame was not measured at this quality.
struct FrameTimes {
    double draft = 0;  // CPU s, as are the others
    double preview = 0;
    double final = 0;
};

/// Throws Error if the file cannot be read.
[[nodiscard]] std::vector<FrameTimes> read_frame_times(const std::string& path);

/// Frames of the film that the file describes; it has rows for some of them, evenly spaced.
inline constexpr int kFramesOfFile = 240;

/// The CPU seconds of `count` frames at a quality (draft, preview or final). A film longer than the
/// measured one repeats it. A final frame that was not measured takes as many times its draft time
/// as the measured ones do on average.
[[nodiscard]] std::vector<double> film_seconds(const std::vector<FrameTimes>& measured,
                                               const std::string& quality, int count);

}  // namespace carom::bench
