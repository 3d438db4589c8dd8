#include "render/sampling/gaussian_lobe.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/elementary.h"
#include "core/elementary_float.h"
#include "render/geometry/trigonometry.h"
#include "render/sampling/one_minus_epsilon.h"

namespace carom::render {
namespace {

// Polynomials in w - 2.5 for w < 5 and in sqrt(w) - 3 above; the highest power comes first.
constexpr std::array<float, 9> kCentre{2.81022636e-08f,  3.43273939e-07f, -3.5233877e-06f,
                                       -4.39150654e-06f, 0.00021858087f,  -0.00125372503f,
                                       -0.00417768164f,  0.246640727f,    1.50140941f};
constexpr std::array<float, 9> kTail{-0.000200214257f, 0.000100950558f, 0.00134934322f,
                                     -0.00367342844f,  0.00573950773f,  -0.0076224613f,
                                     0.00943887047f,   1.00167406f,     2.83297682f};

float polynomial(const std::array<float, 9>& coefficients, float x) {
    float sum = 0;
    for (const float coefficient : coefficients) {
        sum = sum * x + coefficient;
    }
    return sum;
}

constexpr double kHalfTurn = std::numbers::pi / 2;

}  // namespace

float inverse_erf(float y) {
    const float w = -logarithm((1 - y) * (1 + y));
    return y * (w < 5 ? polynomial(kCentre, w - 2.5f) : polynomial(kTail, std::sqrt(w) - 3));
}

V3f sample_gaussian_lobe(const V2f& u, float spread) {
    const float scale = std::numbers::sqrt2_v<float> * spread;
    const float most = error_function(0.5f * kPi / scale);
    const float fraction = std::min(u.x * most, kOneMinusEpsilon);
    const float angle = std::min(scale * inverse_erf(fraction), 0.5f * kPi);
    const SinCos from_axis = sin_cos(angle);
    const SinCos azimuth = sin_cos_turn(u.y);
    return V3f(from_axis.sine * azimuth.cosine, from_axis.sine * azimuth.sine, from_axis.cosine);
}

double pdf_gaussian_lobe_angle(double angle, double spread) {
    if (angle < 0 || angle > kHalfTurn) {
        return 0;
    }
    const double x = angle / spread;
    const double most = error_function(kHalfTurn / (std::numbers::sqrt2 * spread));
    return std::sqrt(2 / std::numbers::pi) * exponential(-0.5 * x * x) / (spread * most);
}

}  // namespace carom::render
