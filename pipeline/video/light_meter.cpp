#include "pipeline/video/light_meter.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "pipeline/video/hdr_view.h"

namespace carom::pipeline {

namespace {

/// pq_decode of every 16-bit signal.
class DecodingTable {
  public:
    DecodingTable() {
        for (std::size_t i = 0; i < light_.size(); ++i) {
            light_[i] = pq_decode(static_cast<double>(i) / static_cast<double>(light_.size() - 1));
        }
    }
    [[nodiscard]] double operator()(std::uint16_t signal) const { return light_[signal]; }

  private:
    std::array<double, 65536> light_{};
};

int rounded(double light) {
    return std::max(1, static_cast<int>(std::lround(light)));
}

}  // namespace

void LightMeter::add(std::span<const std::uint16_t> signal) {
    static const DecodingTable light;
    double sum = 0;
    for (std::size_t i = 0; i + 2 < signal.size(); i += 3) {
        const double highest = light(std::max({signal[i], signal[i + 1], signal[i + 2]}));
        sum += highest;
        brightest_ = std::max(brightest_, highest);
    }
    const std::size_t pixels = std::max<std::size_t>(1, signal.size() / 3);
    brightest_mean_ = std::max(brightest_mean_, sum / static_cast<double>(pixels));
}

LightLevels LightMeter::levels() const {
    return {rounded(brightest_), rounded(brightest_mean_)};
}

}  // namespace carom::pipeline
