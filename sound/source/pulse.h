// The force of a contact over its duration, and what a complex pole answers to it, in closed form.
#pragma once

#include <array>
#include <cstddef>

#include "sound/source/complex.h"

namespace carom::sound {

/// The force of a contact of duration T is a sum of sines,
///     f(t) = (1/T) sum_k b_k sin(w_k t),   w_k = k pi / T,   k = 1, 3, 5, 7, 9,
/// for t in [0, T], and 0 outside. The coefficients are a least-squares fit to the force of two
/// elastic spheres (Hertz, J. reine angew. Math. 92, 1882: m a = -k d^(3/2)), within 0.8 % of its
/// peak. A single half sine, which is usual, radiates 2.2 to 3.5 dB less.
///
/// What it radiates follows the slope of the force, which begins and ends at once there: over a
/// contact of some milliseconds that is a tick at both ends. The force of something soft, such as a
/// cushion under its cloth, begins and ends without a slope: sum_k k b_k = 0. It is a fit to the
/// force of a contact of 0.9 T, smoothed by a raised cosine over 0.1 T (tuned). Up to the frequency
/// 8 / T its spectrum is that of the elastic one within 3 dB, and from 15 / T on 20 dB lower.
inline constexpr std::size_t kPulseSines = 5;
enum class PulseShape { elastic, soft };

/// b_k, so that the area of f is 1.
[[nodiscard]] const std::array<double, kPulseSines>& pulse_coefficients(PulseShape shape);

/// k of the index-th sine: 1, 3, 5, 7, 9.
[[nodiscard]] constexpr double pulse_harmonic(std::size_t index) {
    return 2.0 * static_cast<double>(index) + 1;
}

/// The convolution r of f with e^{pt}, for a pole p (1/s) with a real part below 0:
///     during the contact   r(t) = e^{pt} a - sum_k [c_k cos(w_k t) + s_k sin(w_k t)]
///     after it             r(t) = (e^{p(t - T)} + e^{pt}) a
/// with d_k = (b_k/T) / (p^2 + w_k^2), a = sum_k w_k d_k, c_k = w_k d_k and s_k = p d_k.
struct PoleResponse {
    Complex a;
    std::array<Complex, kPulseSines> c{};
    std::array<Complex, kPulseSines> s{};
};
[[nodiscard]] PoleResponse pole_response(Complex pole, double duration, PulseShape shape);

}  // namespace carom::sound
