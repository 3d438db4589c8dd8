// The highest value of a signal between its samples.
#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace carom::sound {

/// Interpolates a signal at quarters of the sample distance, as ITU-R BS.1770-4, annex 2 measures
/// true peaks. The interpolation is a sinc of 24 samples under a Hann window; it is flat to 20 kHz.
/// Unlike the one in libebur128 it has the same bits everywhere, so a film's gain may depend on it.
class PeakInterpolator {
  public:
    static constexpr std::size_t kTaps = 24;
    /// How many samples later than pushed a value is known.
    static constexpr std::size_t kDelay = kTaps / 2;

    /// The highest absolute value from the sample pushed kDelay calls ago up to, and not including,
    /// the one after it. Samples before the first are 0. It may return 0, quickly, if the value is
    /// not above `least`, which must not fall from call to call.
    double push_above(double sample, double least);

  private:
    [[nodiscard]] double highest() const;

    std::array<double, 2 * kTaps> window_{};  // the last kTaps samples, twice, so that they adjoin
    std::size_t next_ = 0;
    std::size_t loud_for_ = 0;  // pushes for which a loud sample is in the window
};

/// Meters the true peak of one channel.
class TruePeakMeter {
  public:
    void add(std::span<const double> samples);

    /// The highest absolute value so far, in the unit of the samples. The signal is taken to end
    /// with silence.
    [[nodiscard]] double peak() const;

  private:
    PeakInterpolator interpolator_;
    double peak_ = 0;
};

}  // namespace carom::sound
