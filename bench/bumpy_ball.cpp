#include "bench/bumpy_ball.h"

#include <cmath>
#include <numbers>

namespace carom::bench {

render::MeshShape bumpy_ball(int count, double radius) {
    const int rings = static_cast<int>(std::ceil(std::sqrt(count / 4.0)));
    const int sectors = 2 * rings;
    render::MeshShape mesh;
    for (int r = 0; r <= rings; ++r) {
        for (int s = 0; s < sectors; ++s) {
            const double theta = std::numbers::pi * r / rings;
            const double phi = 2 * std::numbers::pi * s / sectors;
            const double bumps = std::sin(9 * theta) * std::cos(7 * phi) +
                                 0.3 * std::sin(61 * theta) * std::cos(53 * phi);
            const double size = radius * (1 + 0.12 * bumps);
            mesh.vertices.emplace_back(size * std::sin(theta) * std::cos(phi),
                                       size * std::sin(theta) * std::sin(phi),
                                       size * std::cos(theta));
        }
    }
    for (int r = 0; r < rings; ++r) {
        for (int s = 0; s < sectors; ++s) {
            const auto at = [&](int ring, int sector) {
                return static_cast<std::uint32_t>(ring * sectors + sector % sectors);
            };
            mesh.triangles.push_back({at(r, s), at(r + 1, s), at(r + 1, s + 1)});
            mesh.triangles.push_back({at(r, s), at(r + 1, s + 1), at(r, s + 1)});
        }
    }
    return mesh;
}

}  // namespace carom::bench
