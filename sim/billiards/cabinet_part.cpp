#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/core.h>

#include "core/elementary.h"
#include "sim/billiards/parts.h"
#include "sim/billiards/surface_builder.h"

namespace carom::sim::billiards {

namespace {

constexpr double kApronTop = kRailBottom - 0.001;
constexpr double kApronDepth = 0.17;  // at most; less on low tables, m
constexpr double kApronBack = 0.045;  // from the rails' outer edge to the apron's inside, m
constexpr double kLegInset = 0.118;   // of a leg's axis from the rails' outer edge, m
constexpr double kLegInside = 0.05;   // of a leg, hidden behind the apron, m
constexpr double kLegRadius = 0.062;  // at its widest, m
constexpr double kMaxLegGap = 1.6;    // between legs along a side; more pairs are added, m

double apron_bottom(const TableMeasures& measures) {
    return kApronTop - std::min(kApronDepth, 0.3 * measures.height);
}

// A turned leg: height above the floor as a fraction of the leg's, and radius as a fraction of the
// widest.
constexpr std::array<std::array<double, 2>, 13> kTurning{{{0.00, 0.62},
                                                          {0.03, 0.66},
                                                          {0.06, 0.60},
                                                          {0.10, 0.48},
                                                          {0.30, 0.60},
                                                          {0.55, 0.82},
                                                          {0.68, 0.92},
                                                          {0.76, 0.78},
                                                          {0.79, 0.60},
                                                          {0.82, 0.80},
                                                          {0.86, 0.98},
                                                          {0.92, 1.00},
                                                          {1.00, 1.00}}};

double turning_slope(std::size_t index) {
    if (index == 0 || index + 1 == kTurning.size()) {
        return 0;
    }
    const auto& before = kTurning[index - 1];
    const auto& after = kTurning[index + 1];
    return (after[1] - before[1]) / (after[0] - before[0]);
}

// Radius and its slope against height, by cubic Hermite curves through the points above.
std::array<double, 2> turning_at(double height) {
    std::size_t index = 0;
    while (index + 2 < kTurning.size() && kTurning[index + 1][0] <= height) {
        ++index;
    }
    const auto& [h0, r0] = kTurning[index];
    const auto& [h1, r1] = kTurning[index + 1];
    const double h = h1 - h0;
    const double s = std::clamp((height - h0) / h, 0.0, 1.0);
    const double m0 = h * turning_slope(index);
    const double m1 = h * turning_slope(index + 1);
    const double d = r1 - r0;
    const double c2 = 3 * d - 2 * m0 - m1;
    const double c3 = m0 + m1 - 2 * d;
    return {r0 + s * (m0 + s * (c2 + s * c3)), (m0 + s * (2 * c2 + s * 3 * c3)) / h};
}

Surface build_leg(const std::string& name, const Vec2& axis, double floor, double top) {
    constexpr int kRings = 54;
    constexpr int kAround = 40;
    SurfaceBuilder builder(name, SurfacePart::leg);
    std::vector<std::vector<SurfaceVertex>> rows;
    const double height = top - floor;
    for (int ring = 0; ring <= kRings; ++ring) {
        const double fraction = double(ring) / kRings;
        const auto [radius, slope] = turning_at(fraction);
        const double down = -slope * kLegRadius / height;
        auto& row = rows.emplace_back();
        for (int step = 0; step <= kAround; ++step) {
            const double angle = 2 * std::numbers::pi * (step % kAround) / kAround;
            const SinCos at = sin_cos(angle);
            const Vec2 radial(at.cos, at.sin);
            const Vec2 position = axis + kLegRadius * radius * radial;
            row.push_back(
                {{position.x, position.y, floor + fraction * height},
                 Vec3(radial.x, radial.y, down).normalized(),
                 {fraction * height, kLegRadius * 2 * std::numbers::pi * step / kAround}});
        }
    }
    builder.add_grid(rows);
    const auto add_lid = [&](const std::vector<SurfaceVertex>& row, double facing) {
        std::vector<Vec3> rim;
        for (std::size_t index = 0; index + 1 < row.size(); ++index) {
            rim.push_back(row[index].position);
        }
        builder.add_polygon(rim, {0, 0, facing});
    };
    add_lid(rows.front(), -1);
    add_lid(rows.back(), 1);
    return std::move(builder).finish();
}

}  // namespace

Surface build_apron(const TableLayout& layout) {
    SurfaceBuilder builder("apron", SurfacePart::apron);
    const double bottom = apron_bottom(layout.measures);
    // A band under the rail, a groove, a face that leans inwards, and the back of the board.
    const std::array<ProfilePosition, 9> positions{{{0.012, kApronTop},
                                                    {0.012, kApronTop - 0.018},
                                                    {0.017, kApronTop - 0.018},
                                                    {0.017, kApronTop - 0.022},
                                                    {0.014, kApronTop - 0.022},
                                                    {0.030, bottom + 0.006},
                                                    {0.034, bottom},
                                                    {kApronBack, bottom},
                                                    {kApronBack, kApronTop}}};
    const PlanPath path = outer_path(layout);
    for (std::size_t index = 0; index < positions.size(); ++index) {
        builder.sweep(
            path, straight_profile(positions[index], positions[(index + 1) % positions.size()]));
    }
    return std::move(builder).finish();
}

std::vector<Surface> build_legs(const TableLayout& layout) {
    const Vec2 leg_extent = layout.outer - Vec2(kLegInset);
    const double bottom = apron_bottom(layout.measures);
    const int gaps = std::max(1, static_cast<int>(std::floor(2 * leg_extent.x / kMaxLegGap)));
    std::vector<Surface> legs;
    for (int row = 0; row < 2; ++row) {
        for (int gap = 0; gap <= gaps; ++gap) {
            // One pair of legs at each end, the others evenly spaced between them.
            const Vec2 axis(-leg_extent.x + 2 * leg_extent.x * gap / gaps,
                            row == 0 ? -leg_extent.y : leg_extent.y);
            legs.push_back(build_leg(fmt::format("leg_{}", legs.size() + 1), axis,
                                     -layout.measures.height, bottom + kLegInside));
        }
    }
    return legs;
}

}  // namespace carom::sim::billiards
