#include "bench/farm_frame_times.h"

#include <array>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "core/error.h"

namespace carom::bench {
namespace {

/// The numbers between the commas of a line; 0 where there is nothing.
std::array<double, 4> columns(const std::string& line) {
    std::array<double, 4> values{};
    std::istringstream stream(line);
    std::string text;
    for (double& value : values) {
        if (std::getline(stream, text, ',')) {
            value = std::strtod(text.c_str(), nullptr);
        }
    }
    return values;
}

/// Mean of final / draft over the frames that were measured at both.
double final_ratio(const std::vector<FrameTimes>& measured) {
    double drafts = 0;
    double finals = 0;
    for (const FrameTimes& frame : measured) {
        if (frame.final > 0) {
            drafts += frame.draft;
            finals += frame.final;
        }
    }
    return drafts > 0 ? finals / drafts : 0;
}

}  // namespace

std::vector<FrameTimes> read_frame_times(const std::string& path) {
    std::ifstream file(path);
    std::vector<FrameTimes> times;
    std::string line;
    while (std::getline(file, line)) {
        if (line.empty() || line[0] < '0' || line[0] > '9') {
            continue;  // a comment or the names of the columns
        }
        const auto [frame, draft, preview, final] = columns(line);
        times.push_back({draft, preview, final});
    }
    if (times.empty()) {
        throw Error("there are no frame times in '" + path + "'");
    }
    return times;
}

std::vector<double> film_seconds(const std::vector<FrameTimes>& measured,
                                 const std::string& quality, int count) {
    const double ratio = final_ratio(measured);
    std::vector<double> seconds;
    const auto rows = static_cast<double>(measured.size());
    for (int i = 0; i < count; ++i) {
        // A film of 240 frames or less is the measured film, a longer one repeats it.
        const double place = (i % kFramesOfFile) * rows / kFramesOfFile;
        const FrameTimes& frame = measured[static_cast<std::size_t>(place)];
        if (quality == "draft") {
            seconds.push_back(frame.draft);
        } else if (quality == "preview") {
            seconds.push_back(frame.preview);
        } else {
            seconds.push_back(frame.final > 0 ? frame.final : ratio * frame.draft);
        }
    }
    return seconds;
}

}  // namespace carom::bench
