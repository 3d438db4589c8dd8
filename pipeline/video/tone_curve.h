// One-dimensional curves of the view transforms, stored as tables.
#pragma once

#include <cmath>
#include <functional>
#include <vector>

namespace carom::pipeline {

/// A curve on [0, white], stored as a table with entries spaced evenly in the square root of the
/// argument, and interpolated linearly. Display curves are nearly straight over that axis: 4096
/// entries follow the sRGB curve within 0.02 of a 16-bit step, at the cost of one square root.
class ToneCurve {
  public:
    ToneCurve(const std::function<double(double)>& curve, double white);

    /// The curve at `value`, clamped to [0, white]; 0 for NaN.
    [[nodiscard]] float operator()(float value) const {
        if (!(value > 0)) {  // NaN too
            return table_.front();
        }
        if (value >= white_) {
            return table_.back();
        }
        const float place = std::sqrt(value) * scale_;
        const auto cell = static_cast<int>(place);
        const float fraction = place - static_cast<float>(cell);
        const float* entry = table_.data() + cell;
        return entry[0] + (entry[1] - entry[0]) * fraction;
    }

  private:
    float white_;
    float scale_;  // entries per square root of a unit
    std::vector<float> table_;
};

/// Converts linear light to the sRGB signal, both in [0, 1] (IEC 61966-2-1:1999, section 5.2).
[[nodiscard]] double srgb_encode(double linear);

/// The filmic curve's parameters (see filmic_curve).
struct FilmicParameters {
    double contrast = 1.25;   // slope of the log-log curve in the shadows, > 0
    double shoulder = 0.975;  // how late highlights are compressed, (0, 1]
    double mid_grey = 0.18;   // maps to itself, so that a change of view keeps the exposure
    double white = 16;        // the light that becomes the display's white: 6.5 stops over mid_grey
    double crosstalk =
        0.15;  // fraction of luminance that each channel is mixed with before the curve ...
    double separation = 0.13;  // ... and that is removed after it
};

/// The tone curve of T. Lottes, "Advanced Techniques and Optimization of HDR Color Pipelines", GDC
/// 2016:
///   y = x^a / (x^(a d) b + c)
/// a: contrast, d: shoulder; b and c follow from y(mid_grey) = mid_grey and y(white) = 1.
[[nodiscard]] std::function<double(double)> filmic_curve(const FilmicParameters& parameters);

/// A sigmoid over the logarithm of light (see logarithmic_curve).
struct LogarithmicParameters {
    double mid_grey = 0.18;      // maps to itself
    double stops_below = 10;     // from mid_grey to black
    double stops_above = 6.5;    // from mid_grey to white
    double slope = 0.142;        // of the signal at mid_grey, per stop
    double toe = 2.2;            // the larger, the sharper the bend near black, > 0
    double shoulder = 1.9;       // the same near white
    double display_gamma = 2.2;  // between the signal and the display's light
    double inset = 0.22;  // fraction of the channels' mean that each is mixed with before the curve
    double outset = 0.13;  // and that is removed after it
};

/// The idea of T. Sobotka's AgX (2021): channels are mixed with their mean, then a sigmoid over
/// stops gives the display signal of each, so that every light becomes white as it grows brighter
/// and keeps its hue until then. The sigmoid here is
///   signal(e) = m + a S(k e / a),  S(u) = u / (1 + |u|^p)^(1/p)
/// (Naka and Rushton 1966, "S-potentials from colour units in the retina of fish", made symmetric),
/// where e is the number of stops above mid_grey and m the signal of mid_grey; a follows for each
/// side from the values 0 and 1 at the ends. The returned curve gives the display's linear light.
[[nodiscard]] std::function<double(double)> logarithmic_curve(
    const LogarithmicParameters& parameters);
[[nodiscard]] double white_of(const LogarithmicParameters& parameters);

}  // namespace carom::pipeline
