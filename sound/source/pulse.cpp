#include "sound/source/pulse.h"

#include <numbers>

namespace carom::sound {
namespace {

constexpr double kPi = std::numbers::pi;

using Coefficients = std::array<double, kPulseSines>;

constexpr Coefficients kElastic{1.65316, -0.21389, -0.03908, -0.01612, -0.00849};
/// The last one takes the slope away, k b_k in sum.
constexpr Coefficients kSoft{1.71278, -0.37235, -0.06589, -0.02489,
                             -(1.71278 - 3 * 0.37235 - 5 * 0.06589 - 7 * 0.02489) / 9};

Coefficients with_area_one(Coefficients b) {
    double area = 0;
    for (std::size_t i = 0; i < kPulseSines; ++i) {
        area += b[i] * 2 / (pulse_harmonic(i) * kPi);
    }
    for (double& coefficient : b) {
        coefficient /= area;
    }
    return b;
}

}  // namespace

const std::array<double, kPulseSines>& pulse_coefficients(PulseShape shape) {
    static const Coefficients elastic = with_area_one(kElastic);
    static const Coefficients soft = with_area_one(kSoft);
    return shape == PulseShape::soft ? soft : elastic;
}

PoleResponse pole_response(Complex pole, double duration, PulseShape shape) {
    PoleResponse response;
    const Complex square = pole * pole;
    for (std::size_t i = 0; i < kPulseSines; ++i) {
        const double w = pulse_harmonic(i) * kPi / duration;
        const Complex d =
            Complex{pulse_coefficients(shape)[i] / duration, 0} / (square + Complex{w * w, 0});
        response.c[i] = w * d;
        response.s[i] = pole * d;
        response.a = response.a + response.c[i];
    }
    return response;
}

}  // namespace carom::sound
