#include "sim/shape/mass_properties.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace carom::sim {
namespace {

using Matrix = std::array<std::array<double, 3>, 3>;

/// Adds the integral of x x^T over the tetrahedron (0, a, b, c), whose volume is `volume`:
/// V/20 (s s^T + a a^T + b b^T + c c^T), s = a + b + c.
void add_second_moment(Matrix& sum, double volume, const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 s = a + b + c;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            sum[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] +=
                volume / 20 * (s[i] * s[j] + a[i] * a[j] + b[i] * b[j] + c[i] * c[j]);
        }
    }
}

/// Jacobi's method: turns `m` diagonal, `axes` gets the eigenvectors as columns (Golub and Van
/// Loan, Matrix Computations, section 8.5).
void diagonalise(Matrix& m, Matrix& axes) {
    axes = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    constexpr int kMaxSweeps = 30;
    for (int sweep = 0; sweep < kMaxSweeps; ++sweep) {
        for (std::size_t p = 0; p < 2; ++p) {
            for (std::size_t q = p + 1; q < 3; ++q) {
                if (std::abs(m[p][q]) <= 1e-15 * (std::abs(m[p][p]) + std::abs(m[q][q]))) {
                    continue;
                }
                const double theta = (m[q][q] - m[p][p]) / (2 * m[p][q]);
                const double t =
                    (theta >= 0 ? 1 : -1) / (std::abs(theta) + std::sqrt(theta * theta + 1));
                const double c = 1 / std::sqrt(t * t + 1);
                const double s = t * c;
                for (std::size_t k = 0; k < 3; ++k) {
                    const double kp = m[k][p];
                    const double kq = m[k][q];
                    m[k][p] = c * kp - s * kq;
                    m[k][q] = s * kp + c * kq;
                }
                for (std::size_t k = 0; k < 3; ++k) {
                    const double pk = m[p][k];
                    const double qk = m[q][k];
                    m[p][k] = c * pk - s * qk;
                    m[q][k] = s * pk + c * qk;
                }
                for (std::size_t k = 0; k < 3; ++k) {
                    const double kp = axes[k][p];
                    const double kq = axes[k][q];
                    axes[k][p] = c * kp - s * kq;
                    axes[k][q] = s * kp + c * kq;
                }
            }
        }
    }
}

/// The rotation whose columns are `axes` (made right-handed).
Quat rotation_of(Matrix axes) {
    const auto column = [&](std::size_t k) { return Vec3(axes[0][k], axes[1][k], axes[2][k]); };
    if (column(0).cross(column(1)).dot(column(2)) < 0) {
        for (auto& row : axes) {
            row[2] = -row[2];
        }
    }
    // The largest component first (Shepperd, Quaternion from rotation matrix, J. Guidance and
    // Control 1, 1978).
    const std::array<double, 4> squares{
        1 + axes[0][0] + axes[1][1] + axes[2][2], 1 + axes[0][0] - axes[1][1] - axes[2][2],
        1 - axes[0][0] + axes[1][1] - axes[2][2], 1 - axes[0][0] - axes[1][1] + axes[2][2]};
    std::size_t best = 0;
    for (std::size_t i = 1; i < 4; ++i) {
        if (squares[i] > squares[best]) {
            best = i;
        }
    }
    const double root = std::sqrt(squares[best]);
    const double f = 0.5 / root;
    const Vec3 difference(axes[2][1] - axes[1][2], axes[0][2] - axes[2][0],
                          axes[1][0] - axes[0][1]);
    if (best == 0) {
        return {0.5 * root, difference * f};
    }
    const std::size_t i = best - 1;
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    Vec3 v;
    v[static_cast<int>(i)] = 0.5 * root;
    v[static_cast<int>(j)] = (axes[j][i] + axes[i][j]) * f;
    v[static_cast<int>(k)] = (axes[k][i] + axes[i][k]) * f;
    return {difference[static_cast<int>(i)] * f, v};
}

}  // namespace

MassProperties mass_properties(const Polyhedron& solid) {
    const Vec3 origin = solid.vertices.front();
    MassProperties result;
    Matrix second{};
    Vec3 first(0, 0, 0);
    for (const PolyhedronFace& face : solid.faces) {
        const Vec3 a = solid.vertices[face.corners[0]] - origin;
        for (std::size_t i = 2; i < face.corners.size(); ++i) {
            const Vec3 b = solid.vertices[face.corners[i - 1]] - origin;
            const Vec3 c = solid.vertices[face.corners[i]] - origin;
            const double volume = a.dot(b.cross(c)) / 6;
            result.volume += volume;
            first += (a + b + c) * (volume / 4);
            add_second_moment(second, volume, a, b, c);
        }
    }
    const Vec3 centre = first / result.volume;
    result.centre = origin + centre;
    Matrix covariance{};
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            const auto si = static_cast<std::size_t>(i);
            const auto sj = static_cast<std::size_t>(j);
            covariance[si][sj] = second[si][sj] / result.volume - centre[i] * centre[j];
        }
    }
    Matrix axes{};
    diagonalise(covariance, axes);
    const double x = covariance[0][0];
    const double y = covariance[1][1];
    const double z = covariance[2][2];
    result.inertia = {y + z, z + x, x + y};
    result.principal = rotation_of(axes);
    return result;
}

Vec3 box_inertia(const Vec3& size) {
    return Vec3(size.y * size.y + size.z * size.z, size.x * size.x + size.z * size.z,
                size.x * size.x + size.y * size.y) /
           12;
}

Vec3 cylinder_inertia(double radius, double height) {
    const double across = (3 * radius * radius + height * height) / 12;
    return {across, across, 0.5 * radius * radius};
}

Vec3 capsule_inertia(double radius, double length) {
    // A cylinder and two hemispheres, each with its fraction of the mass.
    const double cylinder = length / (length + 4.0 / 3.0 * radius);
    const double ends = 1 - cylinder;
    const double along = radius * radius * (0.5 * cylinder + 0.4 * ends);
    const double across =
        cylinder * (3 * radius * radius + length * length) / 12 +
        ends * (0.4 * radius * radius + 0.25 * length * length + 0.375 * length * radius);
    return {across, across, along};
}

double cylinder_volume(double radius, double height) {
    return std::numbers::pi * radius * radius * height;
}

double capsule_volume(double radius, double length) {
    return std::numbers::pi * radius * radius * (length + 4.0 / 3.0 * radius);
}

}  // namespace carom::sim
