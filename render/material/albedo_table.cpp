#include "render/material/albedo_table.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/elementary.h"
#include "render/material/scalar_kernels.h"

namespace carom::render {
namespace {

using scalar::fresnel_dielectric;
using scalar::One;
using Ggx = scalar::GgxOf<One>;

// Points of the quadrature: a Fibonacci lattice (Zaremba 1966, "Good lattice points, discrepancy,
// and numerical integration") of F(18) points. The integrands jump where reflected directions pass
// below the horizon, where a regular grid of as many points has ten times the error.
constexpr int kPoints = 2584;
constexpr int kGenerator = 1597;

V3f direction_at(float cosine) {
    return {std::sqrt(std::max(0.0f, 1.0f - cosine * cosine)), 0.0f, cosine};
}

template <class Integrand>
float mean_over_square(const Integrand& integrand) {
    double sum = 0;
    for (int i = 0; i < kPoints; ++i) {
        const int turned = static_cast<int>(std::int64_t{i} * kGenerator % kPoints);
        sum += integrand(V2f((static_cast<float>(turned) + 0.5f) / kPoints,
                             (static_cast<float>(i) + 0.5f) / kPoints));
    }
    return static_cast<float>(sum / kPoints);
}

template <class Reflectance>
float microfacet_albedo(float alpha, float cosine, const Reflectance& reflectance) {
    const Ggx ggx(alpha);
    const V3f wo = direction_at(cosine);
    return mean_over_square([&](const V2f& u) {
        const V3f m = ggx.sample_visible(wo, u);
        const V3f wi = scalar::reflect<One>(wo, m);
        return wi.z <= 0 ? 0.0f : reflectance(wo.dot(m)) * ggx.sample_weight(wo, wi);
    });
}

// Integral of sin^n over [angle, pi/2], by the midpoint rule over the part where it is above 1e-12.
double integral_of_sine_power(double exponent, double angle) {
    constexpr int kSteps = 256;
    constexpr double kQuarterTurn = 1.5707963267948966;
    const double from = std::max(angle, kQuarterTurn - 7.5 / std::sqrt(exponent + 1));
    const double step = (kQuarterTurn - from) / kSteps;
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) {
        sum += power(sine(from + (i + 0.5) * step), exponent);
    }
    return sum * step;
}

}  // namespace

template <class Albedo>
AlbedoTable AlbedoTable::build(const Albedo& albedo_at) {
    AlbedoTable table;
    for (std::size_t i = 0; i < kAlbedoNodes; ++i) {
        const float root = static_cast<float>(i) / (kAlbedoNodes - 1);
        table.values_[i] = albedo_at(std::max(root * root, 1e-4f));
    }
    return table;
}

AlbedoTable AlbedoTable::of_dielectric(float alpha, float ior) {
    return build([&](float cosine) {
        return microfacet_albedo(alpha, cosine,
                                 [&](float c) { return fresnel_dielectric<One>(c, ior); });
    });
}

AlbedoTable AlbedoTable::of_mirrors(float alpha) {
    return build(
        [&](float cosine) { return microfacet_albedo(alpha, cosine, [](float) { return 1.0f; }); });
}

AlbedoTable AlbedoTable::of_glass(float alpha, float index) {
    const AlbedoTable reflected = of_dielectric(alpha, index);
    const Ggx ggx(alpha);
    return build([&](float cosine) {
        const V3f wo = direction_at(cosine);
        return reflected.at(cosine) + mean_over_square([&](const V2f& u) {
                   const V3f m = ggx.sample_visible(wo, u);
                   const V3f wi = scalar::refracted_at<One>(wo, m, index);
                   return wi.z >= 0 ? 0.0f
                                    : (1.0f - fresnel_dielectric<One>(wo.dot(m), index)) /
                                          (1.0f + ggx.lambda(V3f(wi.x, wi.y, -wi.z)));
               });
    });
}

AlbedoTable AlbedoTable::of_sheen() {
    return build([](float cosine) {
        const V3f wo = direction_at(cosine);
        // Uniform over the hemisphere; u.x is the cosine.
        return mean_over_square([&](const V2f& u) {
            const float sine = std::sqrt(1.0f - u.x * u.x);
            const auto angle = scalar::sin_cos_turn<One>(u.y);
            const V3f wi(sine * angle.cosine, sine * angle.sine, u.x);
            return 2.0f * kPi * scalar::sheen_reflection<One>(wo.z, wi.z, (wo + wi).length2());
        });
    });
}

// Tilting the surface by d(angle) cuts off, along the half circle in which it intersects the lobe,
//   (n + 1) / (2 pi) sin^n(angle) d(angle) x integral of cos^(n + 1) over that half circle,
// and at a right angle half of the lobe remains. So the fraction is
//   1/2 + 1/2 x integral of sin^n over [angle, pi/2] / integral of sin^n over [0, pi/2].
AlbedoTable AlbedoTable::of_cosine_lobe(double exponent) {
    const double whole = integral_of_sine_power(exponent, 0);
    return build([&](float cosine) {
        const double angle = arccosine(std::min(1.0, static_cast<double>(cosine)));
        return static_cast<float>(0.5 + 0.5 * integral_of_sine_power(exponent, angle) / whole);
    });
}

float AlbedoTable::at(float cosine) const {
    return scalar::albedo_at<scalar::One>(values_.data(), 0, cosine);
}

}  // namespace carom::render
