#include "sim/numeric/rotation.h"

#include <algorithm>
#include <cmath>

#include "core/elementary.h"

namespace carom::sim {

Quat rotation_by(const Vec3& turn) {
    const double angle = std::sqrt(turn.dot(turn));
    if (angle < 1e-150) {
        return {};
    }
    const SinCos half = sin_cos(0.5 * angle);
    return {half.cos, turn * (half.sin / angle)};
}

Quat turned(const Quat& from, const Vec3& omega0, const Vec3& omega1, double duration) {
    constexpr double kMaxTurn = 0.5;  // rad
    const Vec3 cross = omega1.cross(omega0);
    const Vec3 mean = (omega0 + omega1) * 0.5;
    const double fastest = std::sqrt(std::max(omega0.dot(omega0), omega1.dot(omega1)));
    const bool parallel = cross == Vec3(0, 0, 0);
    const double steps = parallel ? 1 : std::max(1.0, std::ceil(fastest * duration / kMaxTurn));
    const int count = static_cast<int>(std::min(steps, 1e6));
    const double h = duration / count;
    // For linear omega the cross product of a substep's ends is that of the whole step over count.
    const Vec3 bend = cross * (h * h / (12 * count));
    const Vec3 slope = (omega1 - omega0) / count;
    Quat result = from;
    for (int i = 0; i < count; ++i) {
        const Vec3 middle = count == 1 ? mean : omega0 + slope * (i + 0.5);
        result = rotation_by(middle * h + bend) * result;
    }
    const double norm = std::sqrt(result.r * result.r + result.v.dot(result.v));
    return {result.r / norm, result.v / norm};
}

}  // namespace carom::sim
