#include "sim/numeric/polynomial.h"

#include <algorithm>
#include <cmath>

namespace carom::sim {
namespace {

Quartic derivative(const Quartic& c) {
    return {c[1], 2 * c[2], 3 * c[3], 4 * c[4], 0};
}

std::size_t degree(const Quartic& c) {
    for (std::size_t n = 4; n > 0; --n) {
        if (c[n] != 0) {
            return n;
        }
    }
    return 0;
}

/// The root in [a, b], where the polynomial has opposite signs (or is zero) at the ends: Newton's
/// iteration that falls back to bisection where it leaves the bracket or its steps do not halve
/// (Press et al., Numerical Recipes, 3rd ed., section 9.4).
double root_between(const Quartic& c, const Quartic& slope, double a, double b) {
    constexpr double kExact = 4e-16;  // relative
    const bool rises = evaluate(c, a) < 0;
    double t = 0.5 * (a + b);
    double last_step = b - a;
    for (int i = 0; i < 200; ++i) {
        const double f = evaluate(c, t);
        if (f == 0) {
            return t;
        }
        ((f < 0) == rises ? a : b) = t;
        double next = t - f / evaluate(slope, t);
        if (!(next > a && next < b) || 2 * std::abs(next - t) > last_step) {
            next = a + 0.5 * (b - a);
        }
        last_step = std::abs(next - t);
        t = next;
        if (last_step <= kExact * std::abs(t)) {
            break;
        }
    }
    return t;
}

std::size_t linear_or_quadratic(const Quartic& c, std::size_t n, double low, double high,
                                std::array<double, 4>& roots) {
    std::size_t count = 0;
    const auto keep = [&](double t) {
        if (t > low && t < high) {
            roots[count++] = t;
        }
    };
    if (n == 1) {
        keep(-c[0] / c[1]);
        return count;
    }
    const double discriminant = c[1] * c[1] - 4 * c[2] * c[0];
    if (!(discriminant > 0)) {
        return 0;
    }
    // The form without cancellation (Press et al., Numerical Recipes, 3rd ed., section 5.6).
    const double q = -0.5 * (c[1] + std::copysign(std::sqrt(discriminant), c[1]));
    double first = q / c[2];
    double second = q != 0 ? c[0] / q : 0;
    if (first > second) {
        std::swap(first, second);
    }
    keep(first);
    keep(second);
    return count;
}

/// Nodes that divide [low, high] into intervals on which the polynomial is monotone, ends included.
std::size_t monotone_nodes(const Quartic& slope, double low, double high,
                           std::array<double, 6>& nodes) {
    std::array<double, 4> inner{};
    const std::size_t count = sign_changes(slope, low, high, inner);
    nodes[0] = low;
    for (std::size_t i = 0; i < count; ++i) {
        nodes[i + 1] = inner[i];
    }
    nodes[count + 1] = high;
    return count + 2;
}

/// True if the polynomial is positive in [0, high] already by the signs and sizes of its
/// coefficients, as it is for most of the surfaces that a ball may meet but does not.
bool stays_positive(const Quartic& c, double high) {
    constexpr double kRounding = 1e-12;
    double least = 0;
    for (std::size_t n = 4; n > 0; --n) {
        least = (least + std::min(c[n], 0.0)) * high;
    }
    return c[0] * (1 - kRounding) + least > 0;
}

}  // namespace

double evaluate(const Quartic& c, double t) {
    return c[0] + t * (c[1] + t * (c[2] + t * (c[3] + t * c[4])));
}

std::size_t sign_changes(const Quartic& c, double low, double high, std::array<double, 4>& roots) {
    const std::size_t n = degree(c);
    if (n == 0 || !(low < high)) {
        return 0;
    }
    if (n <= 2) {
        return linear_or_quadratic(c, n, low, high, roots);
    }
    const Quartic slope = derivative(c);
    std::array<double, 6> nodes{};
    const std::size_t node_count = monotone_nodes(slope, low, high, nodes);
    std::size_t count = 0;
    for (std::size_t i = 0; i + 1 < node_count && count < roots.size(); ++i) {
        const double fa = evaluate(c, nodes[i]);
        const double fb = evaluate(c, nodes[i + 1]);
        if ((fa > 0 && fb < 0) || (fa < 0 && fb > 0)) {
            roots[count++] = root_between(c, slope, nodes[i], nodes[i + 1]);
        } else if (fb == 0 && i + 2 < node_count) {
            roots[count++] = nodes[i + 1];
        }
    }
    return count;
}

std::optional<double> first_descent(const Quartic& c, double low, double high) {
    if (!(low < high) || (low == 0 && stays_positive(c, high))) {
        return std::nullopt;
    }
    const Quartic slope = derivative(c);
    std::array<double, 6> nodes{};
    const std::size_t node_count = monotone_nodes(slope, low, high, nodes);
    double fa = evaluate(c, low);
    for (std::size_t i = 0; i + 1 < node_count; ++i) {
        const double fb = evaluate(c, nodes[i + 1]);
        if (fa > 0 && fb <= 0) {
            return fb == 0 ? nodes[i + 1] : root_between(c, slope, nodes[i], nodes[i + 1]);
        }
        fa = fb;
    }
    return std::nullopt;
}

}  // namespace carom::sim
