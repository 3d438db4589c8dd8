// The force of a contact and the answer of a pole, against integrals.
#include "sound/source/pulse.h"

#include <cmath>
#include <functional>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/sound/closed_forms.h"

namespace carom::sound {
namespace {

/// Simpson's rule with halved intervals until both agree.
double adaptive(const std::function<double(double)>& f, double a, double b, double tolerance,
                int depth = 40) {
    const auto simpson = [&](double l, double r) {
        return (r - l) / 6 * (f(l) + 4 * f((l + r) / 2) + f(r));
    };
    const double middle = (a + b) / 2;
    const double whole = simpson(a, b);
    const double halves = simpson(a, middle) + simpson(middle, b);
    if (depth == 0 || std::abs(halves - whole) < 15 * tolerance) {
        return halves + (halves - whole) / 15;
    }
    return adaptive(f, a, middle, tolerance / 2, depth - 1) +
           adaptive(f, middle, b, tolerance / 2, depth - 1);
}

Complex convolution(Complex pole, double duration, double time, PulseShape shape) {
    const auto part = [&](bool is_real) {
        const auto f = [&](double u) {
            const Complex e = exponential((time - u) * pole);
            return pulse_force(u, duration, shape) * (is_real ? e.re : e.im);
        };
        const double end = std::min(time, duration);
        double sum = 0;
        for (int i = 0; i < 16; ++i) {  // halving alone may miss a narrow peak
            sum += adaptive(f, end * i / 16, end * (i + 1) / 16, 1e-13);
        }
        return sum;
    };
    return {part(true), part(false)};
}

TEST(Pulse, Force_Integrated_HasAreaOne) {
    for (const PulseShape shape : {PulseShape::elastic, PulseShape::soft}) {
        for (const double duration : {50e-6, 300e-6, 5.5e-3}) {
            const auto f = [&](double t) { return pulse_force(t, duration, shape); };
            EXPECT_NEAR(adaptive(f, 0, duration, 1e-13), 1, 1e-10);
        }
    }
}

TEST(Pulse, Force_AtMirroredTimes_IsTheSame) {
    for (int i = 1; i < 50; ++i) {
        const double t = 4e-6 * i;
        EXPECT_NEAR(pulse_force(t, 400e-6), pulse_force(400e-6 - t, 400e-6), 1e-8);
    }
    EXPECT_EQ(pulse_force(-1e-9, 400e-6), 0);
    EXPECT_EQ(pulse_force(401e-6, 400e-6), 0);
}

// The peak of the Hertz force over its mean: 4/3 E sqrt(R) d^(3/2) T / (2 m v) with T = 2.9433 d/v
// and d^(5/2) = 15 m v^2 / (16 E sqrt R) is 2.9433 x 5/8 = 1.8396.
TEST(Pulse, Force_AtItsPeak_IsThatOfTwoElasticSpheres) {
    EXPECT_NEAR(pulse_force(0.5, 1), 2.9433 * 5 / 8, 0.008 * 1.84);
}

// The exact force: m d'' = -k d^(3/2), by Runge and Kutta's method in units in which m, k and the
// speed are 1.
TEST(Pulse, Force_WholeCourse_IsWithinOnePercentOfHertz) {
    double d = 0;
    double v = 1;
    constexpr double h = 1e-4;
    std::vector<double> force;
    const auto acceleration = [](double x) { return x > 0 ? -x * std::sqrt(x) : 0.0; };
    while (d >= 0) {
        force.push_back(-acceleration(d));
        const double k1 = acceleration(d);
        const double k2 = acceleration(d + h / 2 * v);
        const double k3 = acceleration(d + h / 2 * v + h * h / 4 * k1);
        const double k4 = acceleration(d + h * v + h * h / 2 * k2);
        d += h * v + h * h / 6 * (k1 + k2 + k3);
        v += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    }
    const double duration = h * static_cast<double>(force.size());
    EXPECT_NEAR(duration, 3.2181, 2e-3);  // 2.9433 (5/4)^(2/5)
    const double highest = *std::max_element(force.begin(), force.end());
    for (std::size_t i = 0; i < force.size(); ++i) {
        const double t = h * static_cast<double>(i);
        EXPECT_NEAR(2 * pulse_force(t, duration), force[i], 0.01 * highest) << t;
        EXPECT_NEAR(2 * pulse_force(t, duration, PulseShape::soft), force[i], 0.11 * highest);
    }
}

// With a slope at its beginning a force rises in proportion to the time, without slope and
// curvature to its third power.
TEST(Pulse, SoftForce_BeginsAndEndsWithoutASlope) {
    for (const double part : {1e-3, 1e-4}) {
        const double soft = pulse_force(part, 1, PulseShape::soft);
        EXPECT_LT(soft, 2000 * part * part * part);
        EXPECT_NEAR(pulse_force(1 - part, 1, PulseShape::soft), soft, 1e-12);
        EXPECT_GT(pulse_force(part, 1), part);
    }
}

// What a sphere radiates while it is pushed for 5.5 ms, above 2 kHz, where nothing of the push's
// own course is.
TEST(Pulse, SoftForce_MakesNoTicks) {
    const auto density = [](PulseShape shape, double frequency) {
        const auto part = [&](double phase) {
            const auto f = [&](double t) {
                return pulse_force(t, 5.5e-3, shape) *
                       std::cos(2 * std::numbers::pi * frequency * t - phase);
            };
            double sum = 0;
            for (int i = 0; i < 64; ++i) {
                sum += adaptive(f, 5.5e-3 * i / 64, 5.5e-3 * (i + 1) / 64, 1e-14);
            }
            return sum;
        };
        return std::hypot(part(0), part(std::numbers::pi / 2));
    };
    for (const double frequency : {3050.0, 4050.0, 5050.0}) {
        EXPECT_LT(20 * std::log10(density(PulseShape::soft, frequency) /
                                  density(PulseShape::elastic, frequency)),
                  -15)
            << frequency;
    }
}

TEST(Pulse, PoleResponse_AgainstQuadrature_AgreesToNineDigits) {
    const double kappa = 343 / 0.028575;
    for (const Complex pole : {Complex{-kappa, kappa}, Complex{-35, 710}, Complex{-7840, 0}}) {
        for (const double duration : {283e-6, 390e-6, 1e-3}) {
            for (const double part : {0.1, 0.5, 0.99, 1.0, 1.3, 4.0}) {
                const double time = part * duration;
                for (const PulseShape shape : {PulseShape::elastic, PulseShape::soft}) {
                    const Complex exact = convolution(pole, duration, time, shape);
                    const Complex found = pole_response_at(pole, duration, time, shape);
                    EXPECT_NEAR(found.re, exact.re, 1e-9);
                    EXPECT_NEAR(found.im, exact.im, 1e-9);
                }
            }
        }
    }
}

TEST(Pulse, PoleResponse_BeforeTheContact_IsZero) {
    EXPECT_EQ(pole_response_at({-1000, 1000}, 1e-3, 0), (Complex{0, 0}));
}

// The force is a pulse of area 1 for a pole that moves slowly.
TEST(Pulse, PoleResponse_OfAShortContact_IsTheImpulseResponse) {
    const Complex pole{-10, 300};
    const Complex found = pole_response_at(pole, 1e-6, 2e-3);
    const Complex exact = exponential((2e-3 - 0.5e-6) * pole);
    EXPECT_NEAR(found.re, exact.re, 1e-7);
    EXPECT_NEAR(found.im, exact.im, 1e-7);
}

}  // namespace
}  // namespace carom::sound
