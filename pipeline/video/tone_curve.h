// One-dimensional curves of the view transforms, as tables.
#pragma once

#include <functional>
#include <vector>

namespace carom::pipeline {

/// A curve on [0, white], held as a table that is even in the square root of its argument and
/// interpolated linearly: display curves are nearly straight over that axis, so that 4096 entries
/// stay within 0.02 of a 16-bit step of the sRGB curve, at the price of one square root.
class ToneCurve {
  public:
    ToneCurve(const std::function<double(double)>& curve, double white);

    /// The curve at `value`, held at its ends outside [0, white]; 0 for NaN.
    [[nodiscard]] float operator()(float value) const;

  private:
    float white_;
    float scale_;  // entries per square root of a unit
    std::vector<float> table_;
};

/// Linear light to sRGB's signal, both in [0, 1] (IEC 61966-2-1:1999, section 5.2).
[[nodiscard]] double srgb_encode(double linear);

/// The filmic curve's parameters (see filmic_curve).
struct FilmicParameters {
    double contrast = 1.25;   // slope over logarithms in the dark, > 0
    double shoulder = 0.975;  // how late highlights are compressed, (0, 1]
    double mid_grey = 0.18;   // is kept, so that a change of view keeps the exposure
    double white = 16;        // the light that becomes the display's white: 6.5 stops over mid_grey
    double crosstalk = 0.15;  // share of its luminance that a channel takes on before the curve ...
    double separation = 0.13;  // ... and gives back after it
};

/// The tone curve of T. Lottes, "Advanced Techniques and Optimization of HDR Color Pipelines", GDC
/// 2016:
///   y = x^a / (x^(a d) b + c)
/// a: contrast, d: shoulder; b and c follow from y(mid_grey) = mid_grey and y(white) = 1.
[[nodiscard]] std::function<double(double)> filmic_curve(const FilmicParameters& parameters);

/// A sigmoid over the logarithm of light (see logarithmic_curve).
struct LogarithmicParameters {
    double mid_grey = 0.18;      // is kept
    double stops_below = 10;     // from there to black
    double stops_above = 6.5;    // and to white
    double slope = 0.142;        // of the signal at mid_grey, per stop
    double toe = 2.2;            // the larger, the more abruptly black is reached, > 0
    double shoulder = 1.9;       // ditto white
    double display_gamma = 2.2;  // between the signal and the display's light
    double inset = 0.22;         // share of the channels' mean that each takes on before the curve
    double outset = 0.13;        // and gives back after it
};

/// The idea of T. Sobotka's AgX (2021): channels are drawn towards their mean, then each passes a
/// sigmoid over stops that is the display's signal, so that every light turns white as it grows and
/// does so along its own hue. The sigmoid here is
///   signal(e) = m + a S(k e / a),  S(u) = u / (1 + |u|^p)^(1/p)
/// (Naka and Rushton 1966, "S-potentials from colour units in the retina of fish", made symmetric),
/// e being stops over mid_grey and m mid_grey's own signal; a, for each side, follows from reaching
/// 0 and 1 at the ends. Returns the display's linear light.
[[nodiscard]] std::function<double(double)> logarithmic_curve(
    const LogarithmicParameters& parameters);
[[nodiscard]] double white_of(const LogarithmicParameters& parameters);

}  // namespace carom::pipeline
