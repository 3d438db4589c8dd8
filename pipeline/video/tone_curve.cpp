#include "pipeline/video/tone_curve.h"

#include <cmath>

#include "sim/timeline/assert.h"

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
    table_.push_back(table_.back());  // read, with weight 0, at the very end
}

float ToneCurve::operator()(float value) const {
    if (!(value > 0)) {  // NaN too
        return table_.front();
    }
    if (value >= white_) {
        return table_.back();
    }
    const float place = std::sqrt(value) * scale_;
    const auto cell = static_cast<std::size_t>(place);
    const float share = place - static_cast<float>(cell);
    return table_[cell] + (table_[cell + 1] - table_[cell]) * share;
}

double srgb_encode(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

std::function<double(double)> filmic_curve(const FilmicParameters& parameters) {
    const double a = parameters.contrast;
    const double ad = a * parameters.shoulder;
    const double mid = parameters.mid_grey;
    const double white = parameters.white;
    // x^a / y = x^(a d) b + c at both points; the difference gives b, the second one c.
    const double left_mid = std::pow(mid, a) / mid;
    const double left_white = std::pow(white, a);
    const double b = (left_white - left_mid) / (std::pow(white, ad) - std::pow(mid, ad));
    const double c = left_white - std::pow(white, ad) * b;
    return [=](double x) { return x <= 0 ? 0 : std::pow(x, a) / (std::pow(x, ad) * b + c); };
}

}  // namespace carom::pipeline
