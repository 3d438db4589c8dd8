// Loudness and true peak of a stereo signal.
#pragma once

#include <memory>
#include <span>

#include "sound/level/true_peak.h"

namespace carom::sound {

/// Meters as EBU R 128 asks, by libebur128. Samples come in blocks of any size and have full scale
/// 1. Memory grows by one number for every 0.1 s.
class LoudnessMeter {
  public:
    LoudnessMeter();
    ~LoudnessMeter();
    LoudnessMeter(LoudnessMeter&&) noexcept;
    LoudnessMeter& operator=(LoudnessMeter&&) noexcept;
    LoudnessMeter(const LoudnessMeter&) = delete;
    LoudnessMeter& operator=(const LoudnessMeter&) = delete;

    /// Both channels have the same size.
    void add(std::span<const double> left, std::span<const double> right);

    /// The integrated loudness so far (ITU-R BS.1770-4), LUFS; minus infinity if all is below -70
    /// LUFS or shorter than 0.4 s. It is rounded to hundredths, because libebur128 calls the C
    /// library's logarithm, whose last bits differ between machines.
    [[nodiscard]] double integrated() const;

    /// The true peak so far, the higher one of both channels, in units of full scale.
    [[nodiscard]] double true_peak() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
    TruePeakMeter left_, right_;
};

}  // namespace carom::sound
