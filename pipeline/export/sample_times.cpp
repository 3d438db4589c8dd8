#include "pipeline/export/sample_times.h"

#include <cmath>
#include <cstdint>

#include "core/error.h"

namespace carom::pipeline {

namespace {

constexpr double kMostSamples = 1e7;     // about 2 GB of text
constexpr double kStepTolerance = 1e-9;  // in steps; includes the end in spite of rounding

}  // namespace

std::vector<double> sample_times(const sim::Timeline& timeline, double rate) {
    if (!(rate > 0 && rate <= kHighestRate)) {
        throw Error("the sampling rate of an export must be above 0 and at most 1e6 samples/s");
    }
    const double steps = (timeline.end_time - timeline.start_time) * rate;
    const double samples = std::floor(steps + kStepTolerance) + 1;
    if (samples * static_cast<double>(timeline.tracks.size()) > kMostSamples) {
        throw Error("the table would have more than ten million rows; use a lower rate");
    }
    std::vector<double> times;
    const auto count = static_cast<std::int64_t>(samples);
    for (std::int64_t n = 0; n < count; ++n) {
        times.push_back(timeline.start_time + static_cast<double>(n) / rate);
    }
    return times;
}

}  // namespace carom::pipeline
