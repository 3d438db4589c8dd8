#include "nonnegative_least_squares.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace carom::sim::test {
namespace {

using Column = std::vector<double>;

double dot(const Column& a, const Column& b) {
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

void subtract(Column& from, const Column& column, double multiple) {
    for (std::size_t i = 0; i < from.size(); ++i) {
        from[i] -= multiple * column[i];
    }
}

/// Columns that are linearly independent, with their QR decomposition: orthonormal `q`, and `r`
/// with column k = sum of r[k][i] q[i] over i <= k.
class Factors {
  public:
    /// False if the column depends on the others.
    bool add(const Column& column) {
        constexpr double kDependent = 1e-9;
        Column rest = column;
        Column products(q_.size() + 1, 0);
        for (int pass = 0; pass < 2; ++pass) {  // twice is enough (Giraud et al. 2005)
            for (std::size_t i = 0; i < q_.size(); ++i) {
                const double product = dot(rest, q_[i]);
                products[i] += product;
                subtract(rest, q_[i], product);
            }
        }
        const double length = std::sqrt(dot(rest, rest));
        if (length <= kDependent * std::sqrt(dot(column, column))) {
            return false;
        }
        products.back() = length;
        for (double& value : rest) {
            value /= length;
        }
        q_.push_back(std::move(rest));
        r_.push_back(std::move(products));
        return true;
    }

    /// The coefficients of the columns that come nearest to `b`.
    [[nodiscard]] Column solve(const Column& b) const {
        Column x(q_.size(), 0);
        Column right(q_.size(), 0);
        for (std::size_t i = 0; i < q_.size(); ++i) {
            right[i] = dot(b, q_[i]);
        }
        for (std::size_t k = q_.size(); k-- > 0;) {
            x[k] = right[k] / r_[k][k];
            for (std::size_t i = 0; i < k; ++i) {
                right[i] -= r_[k][i] * x[k];
            }
        }
        return x;
    }

  private:
    std::vector<Column> q_, r_;
};

/// The unknowns that are not zero, with their columns' factors.
struct Positive {
    std::vector<std::size_t> indices;
    Column values;
};

Column residual_of(const std::vector<Column>& columns, const Column& b, const Positive& positive) {
    Column residual = b;
    for (std::size_t k = 0; k < positive.indices.size(); ++k) {
        subtract(residual, columns[positive.indices[k]], positive.values[k]);
    }
    return residual;
}

/// Moves the unknowns towards the least squares of their columns, and drops those that would become
/// negative on the way.
void settle(const std::vector<Column>& columns, const Column& b, Positive& positive) {
    for (;;) {
        Factors factors;
        Positive kept;
        for (std::size_t k = 0; k < positive.indices.size(); ++k) {
            if (factors.add(columns[positive.indices[k]])) {
                kept.indices.push_back(positive.indices[k]);
                kept.values.push_back(positive.values[k]);
            }
        }
        const Column wanted = factors.solve(b);
        double fraction = 1;
        for (std::size_t k = 0; k < wanted.size(); ++k) {
            if (wanted[k] <= 0) {
                fraction = std::min(fraction, kept.values[k] / (kept.values[k] - wanted[k]));
            }
        }
        positive = {};
        for (std::size_t k = 0; k < wanted.size(); ++k) {
            const double value = kept.values[k] + fraction * (wanted[k] - kept.values[k]);
            if (wanted[k] > 0 || value > 1e-14) {
                positive.indices.push_back(kept.indices[k]);
                positive.values.push_back(std::max(value, 0.0));
            }
        }
        if (fraction == 1 || positive.indices.size() == kept.indices.size()) {
            return;
        }
    }
}

}  // namespace

std::vector<double> nonnegative_residual(const std::vector<std::vector<double>>& columns,
                                         const std::vector<double>& b) {
    constexpr double kClose = 1e-8;  // of |b|: nearer to the best than anybody asks
    const double scale = std::sqrt(dot(b, b));
    Positive positive;
    Column residual = b;
    for (std::size_t round = 0; round < 10 * b.size() + 100; ++round) {
        std::size_t best = columns.size();
        double steepest = kClose * scale;
        for (std::size_t j = 0; j < columns.size(); ++j) {
            const double descent =
                dot(columns[j], residual) / std::sqrt(dot(columns[j], columns[j]));
            if (descent > steepest) {
                steepest = descent;
                best = j;
            }
        }
        if (best == columns.size()) {
            break;
        }
        positive.indices.push_back(best);
        positive.values.push_back(0);
        const double before = dot(residual, residual);
        settle(columns, b, positive);
        residual = residual_of(columns, b, positive);
        if (dot(residual, residual) >= before) {
            break;  // rounding
        }
    }
    return residual;
}

}  // namespace carom::sim::test
