#include "render/sampling/gaussian_lobe.h"

#include <cmath>
#include <numbers>

#include "core/elementary.h"
#include "core/elementary_float.h"
#include "render/geometry/constants.h"
#include "render/sampling/scalar_kernels.h"

namespace carom::render {
namespace {

constexpr double kHalfTurn = std::numbers::pi / 2;

}  // namespace

float inverse_erf(float y) {
    return scalar::inverse_erf<scalar::One>(y);
}

float gaussian_within_a_quarter_turn(float spread) {
    return error_function(0.5f * kPi / (std::numbers::sqrt2_v<float> * spread));
}

V3f sample_gaussian_lobe(const V2f& u, float spread) {
    return scalar::vector_of(scalar::sample_gaussian_lobe<scalar::One>(
        scalar::two(u), spread, gaussian_within_a_quarter_turn(spread)));
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
