#include "pipeline/video/tone_curve.h"

#include <algorithm>
#include <cmath>

#include "core/assert.h"
#include "core/elementary.h"

namespace carom::pipeline {

namespace {

constexpr int kCells = 4096;

}  // namespace

ToneCurve::ToneCurve(const std::function<double(double)>& curve, double white)
    : white_(static_cast<float>(white)), scale_(static_cast<float>(kCells / std::sqrt(white))) {
    CAROM_ASSERT(white > 0);
    table_.reserve(kCells + 2);
    for (int i = 0; i <= kCells; ++i) {
        const double root = static_cast<double>(i) / kCells;
        table_.push_back(static_cast<float>(curve(root * root * white)));
    }
    table_.push_back(table_.back());  // interpolation at `white` reads it with weight 0
}

double srgb_encode(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * power(linear, 1 / 2.4) - 0.055;
}

std::function<double(double)> filmic_curve(const FilmicParameters& parameters) {
    const double a = parameters.contrast;
    const double ad = a * parameters.shoulder;
    const double mid = parameters.mid_grey;
    const double white = parameters.white;
    // x^a / y = x^(a d) b + c holds at both points; the difference gives b, the second point gives
    // c.
    const double left_mid = power(mid, a) / mid;
    const double left_white = power(white, a);
    const double b = (left_white - left_mid) / (power(white, ad) - power(mid, ad));
    const double c = left_white - power(white, ad) * b;
    return [=](double x) { return x <= 0 ? 0 : power(x, a) / (power(x, ad) * b + c); };
}

namespace {

double sigmoid(double u, double exponent) {
    return u / power(1 + power(u, exponent), 1 / exponent);
}

/// a in a S(slope * stops / a) = height, which grows with a from 0 to slope * stops > height.
double amplitude(double height, double slope, double stops, double exponent) {
    CAROM_ASSERT(slope * stops > height);
    double low = height;
    double high = 2 * height;
    const auto reached = [&](double a) { return a * sigmoid(slope * stops / a, exponent); };
    while (reached(high) < height) {
        high *= 2;
    }
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (reached(middle) < height ? low : high) = middle;
    }
    return high;
}

}  // namespace

std::function<double(double)> logarithmic_curve(const LogarithmicParameters& p) {
    const double mid = power(p.mid_grey, 1 / p.display_gamma);
    const double below = amplitude(mid, p.slope, p.stops_below, p.toe);
    const double above = amplitude(1 - mid, p.slope, p.stops_above, p.shoulder);
    return [=](double light) {
        if (light <= 0) {
            return 0.0;
        }
        const double stops =
            std::clamp(logarithm2(light / p.mid_grey), -p.stops_below, p.stops_above);
        const double signal = stops < 0
                                  ? mid - below * sigmoid(-stops * p.slope / below, p.toe)
                                  : mid + above * sigmoid(stops * p.slope / above, p.shoulder);
        return power(std::clamp(signal, 0.0, 1.0), p.display_gamma);
    };
}

double white_of(const LogarithmicParameters& parameters) {
    return parameters.mid_grey * exponential2(parameters.stops_above);
}

}  // namespace carom::pipeline
