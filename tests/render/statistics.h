// Statistical tests for samplers, with fixed seeds and a correction for many tests.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace carom::test {

/// Regularised upper incomplete gamma function Q(a, x), a > 0, x >= 0: the power series below a +
/// 1, the continued fraction above (Abramowitz and Stegun 1964, 6.5.29 and 6.5.31, the latter by
/// Lentz's method).
inline double upper_gamma(double a, double x) {
    if (x <= 0) {
        return 1;
    }
    const double scale = std::exp(a * std::log(x) - x - std::lgamma(a));
    if (x < a + 1) {
        double term = 1 / a;
        double sum = term;
        for (int n = 1; n < 10'000 && term > 1e-16 * sum; ++n) {
            term *= x / (a + n);
            sum += term;
        }
        return 1 - scale * sum;
    }
    double b = x + 1 - a;
    double c = 1e300;
    double d = 1 / b;
    double fraction = d;
    for (int n = 1; n < 10'000; ++n) {
        const double numerator = -n * (n - a);
        b += 2;
        d = 1 / (numerator * d + b);
        c = b + numerator / c;
        fraction *= d * c;
        if (std::abs(d * c - 1) < 1e-15) {
            break;
        }
    }
    return scale * fraction;
}

/// Probability of a chi-square statistic at least this large by chance.
inline double chi_square_tail(double statistic, double degrees_of_freedom) {
    return upper_gamma(0.5 * degrees_of_freedom, 0.5 * statistic);
}

/// Pearson's test of counts against expected counts. Bins with fewer than five expected are pooled;
/// a count in a bin that expects none gives 0.
inline double chi_square_p_value(std::span<const double> observed,
                                 std::span<const double> expected) {
    std::vector<std::size_t> order(expected.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
        return std::pair(expected[i], i) < std::pair(expected[j], j);
    });
    double statistic = 0;
    int bins = 0;
    double pooled_observed = 0;
    double pooled_expected = 0;
    for (const std::size_t i : order) {
        if (expected[i] <= 0) {
            if (observed[i] > 0) {
                return 0;
            }
            continue;
        }
        pooled_observed += observed[i];
        pooled_expected += expected[i];
        if (pooled_expected >= 5) {
            const double difference = pooled_observed - pooled_expected;
            statistic += difference * difference / pooled_expected;
            ++bins;
            pooled_observed = 0;
            pooled_expected = 0;
        }
    }
    if (pooled_expected > 0) {
        const double difference = pooled_observed - pooled_expected;
        statistic += difference * difference / pooled_expected;
        ++bins;
    }
    return bins < 2 ? 1 : chi_square_tail(statistic, bins - 1);
}

/// The level for each of `count` independent tests whose combined error probability is `level`
/// (Sidak 1967).
inline double sidak(double level, int count) {
    return 1 - std::pow(1 - level, 1.0 / count);
}

/// Independent random numbers for tests: PCG32 (O'Neill 2014), from a fixed seed.
class TestRandom {
  public:
    explicit TestRandom(std::uint64_t seed) : state_(seed * 2 + 1) { next(); }

    std::uint32_t next() {
        const std::uint64_t old = state_;
        state_ = old * 6364136223846793005ull + 1442695040888963407ull;
        const std::uint32_t shifted = static_cast<std::uint32_t>(((old >> 18) ^ old) >> 27);
        const std::uint32_t turn = static_cast<std::uint32_t>(old >> 59);
        return (shifted >> turn) | (shifted << ((32 - turn) & 31));
    }

    /// [0, 1)
    float unit() { return static_cast<float>(next() >> 8) * 0x1p-24f; }
    float between(float low, float high) { return low + (high - low) * unit(); }

  private:
    std::uint64_t state_;
};

}  // namespace carom::test
