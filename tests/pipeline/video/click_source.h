// A sound of clicks at known instants, for tests.
#pragma once

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "pipeline/video/sound_source.h"

namespace carom::testing {

/// Pulses exp(-(t / 0.1 ms)^2 / 2): those with even numbers are louder on the left, those with odd
/// numbers on the right. Their spectrum ends at 6 kHz, so that lossy codecs keep their instants.
class ClickSource : public pipeline::SoundSource {
  public:
    explicit ClickSource(std::vector<double> instants,  // s
                         std::int64_t samples = std::numeric_limits<std::int64_t>::max())
        : instants_(std::move(instants)), samples_(samples) {}

    std::size_t read(std::span<double> left, std::span<double> right) override {
        std::size_t count = 0;
        for (; count < left.size() && next_ < samples_; ++count, ++next_) {
            left[count] = value(next_, 0);
            right[count] = value(next_, 1);
        }
        return count;
    }

    /// The sample with that number, of the left channel (0) or the right (1).
    [[nodiscard]] double value(std::int64_t sample, std::size_t channel) const {
        constexpr double kWidth = 1e-4;
        const double time = static_cast<double>(sample) / pipeline::kSoundRate;
        double sum = 0;
        for (std::size_t i = 0; i < instants_.size(); ++i) {
            const double x = (time - instants_[i]) / kWidth;
            if (std::abs(x) < 10) {
                sum += (i % 2 == channel ? 0.8 : 0.4) * std::exp(-x * x / 2);
            }
        }
        return sum;
    }

  private:
    std::vector<double> instants_;
    std::int64_t samples_;
    std::int64_t next_ = 0;
};

}  // namespace carom::testing
