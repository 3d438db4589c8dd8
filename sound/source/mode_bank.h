// A bank of modes that the force of one contact excites, ready to be sampled.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "sound/source/complex.h"
#include "sound/source/pulse.h"

namespace carom::sound {

/// A pole (1/s, with a negative real part) and its residue (Pa): the pressure is 2 Re(residue
/// r(t)), with the response r of pulse.h.
struct Partial {
    Complex pole;
    Complex residue;
};

/// The sum of partials that follow the same force from the same instant. Each partial rings until
/// it has fallen to `least` (Pa), and then fades out, with half a period of a cosine, within the
/// time in which it falls to a half of that.
class ModeBank {
  public:
    ModeBank(double duration, std::span<const Partial> partials, double least,
             PulseShape shape = PulseShape::elastic);

    /// Adds the pressure at the times first, first + step, first + 2 step ... (s, after the force
    /// begins) to `pressures`. The step may be negative: that plays the sound backwards.
    void add(double first, double step, std::span<double> pressures) const;

    /// The time after which it is silent, s. It is silent before 0, too.
    [[nodiscard]] double end() const { return end_; }

  private:
    struct Ring {
        Complex pole;
        Complex during;   // of e^{pt} while the force lasts
        Complex after;    // of e^{p(t - duration)} after it
        double fade = 0;  // s, from which it fades out
        double end = 0;   // s
    };

    void add_fade(const Ring& ring, double first, double step, std::span<double> pressures) const;
    void add_during(double first, double step, std::span<double> pressures) const;

    double duration_;
    double end_;
    std::vector<Ring> rings_;
    std::array<double, kPulseSines> cosines_{};
    std::array<double, kPulseSines> sines_{};
};

}  // namespace carom::sound
