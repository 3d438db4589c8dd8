#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/core.h>

#include "core/elementary.h"
#include "sim/billiards/drawn/drawn_parts.h"
#include "sim/billiards/drawn/profiles.h"
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
constexpr double kJoint = 0.0002;     // half of the gap between two boards, m
// Between legs along a side; more pairs are added, m.
constexpr double kLegGap = 1.6;
constexpr double kSnookerLegGap = 1.2;

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

/// The outline of a leg's cross-section of size 1, closed, and its outward normals.
struct LegOutline {
    std::vector<Vec2> points;
    std::vector<Vec2> normals;
};

LegOutline round_outline() {
    constexpr int kAround = 20;
    LegOutline outline;
    for (int step = 0; step <= kAround; ++step) {
        const SinCos at = sin_cos(2 * std::numbers::pi * (step % kAround) / kAround);
        outline.points.emplace_back(at.cos, at.sin);
        outline.normals.emplace_back(at.cos, at.sin);
    }
    return outline;
}

LegOutline square_outline() {
    constexpr double kEdge = 0.14;  // rounding of the edges
    constexpr int kSteps = 4;
    LegOutline outline;
    for (int corner = 0; corner < 4; ++corner) {
        const SinCos turn = sin_cos(0.5 * std::numbers::pi * corner);
        for (int step = 0; step <= kSteps; ++step) {
            const SinCos at = sin_cos(0.5 * std::numbers::pi * (corner + double(step) / kSteps));
            const Vec2 centre = (1 - kEdge) * Vec2(turn.cos - turn.sin, turn.sin + turn.cos);
            outline.points.push_back(centre + kEdge * Vec2(at.cos, at.sin));
            outline.normals.emplace_back(at.cos, at.sin);
        }
    }
    outline.points.push_back(outline.points.front());
    outline.normals.push_back(outline.normals.front());
    return outline;
}

/// A leg's cross-sections from the floor up: height, size and slope of the size against height.
struct LegRing {
    double height = 0;  // m
    double size = 0;
    double slope = 0;
};

std::vector<LegRing> turned_rings(double height) {
    constexpr int kRings = 34;
    std::vector<LegRing> rings;
    for (int ring = 0; ring <= kRings; ++ring) {
        const double fraction = double(ring) / kRings;
        const auto [radius, slope] = turning_at(fraction);
        rings.push_back({fraction * height, kLegRadius * radius, kLegRadius * slope / height});
    }
    return rings;
}

/// A square post that tapers towards a foot. Sharp edges have two rings.
std::vector<LegRing> post_rings(double height) {
    const std::array<std::array<double, 2>, 6> corners{{{0.0, 0.060},
                                                        {0.025, 0.060},
                                                        {0.030, 0.054},
                                                        {0.060, 0.054},
                                                        {0.064, 0.058},
                                                        {height, 0.078}}};
    std::vector<LegRing> rings;
    for (std::size_t index = 0; index + 1 < corners.size(); ++index) {
        const auto& [low, low_size] = corners[index];
        const auto& [high, high_size] = corners[index + 1];
        const double slope = (high_size - low_size) / (high - low);
        rings.push_back({low, low_size, slope});
        rings.push_back({high, high_size, slope});
    }
    return rings;
}

Surface draw_leg(const std::string& name, const Vec2& axis, double floor,
                 const std::vector<LegRing>& rings, const LegOutline& outline) {
    SurfaceBuilder builder(name, SurfacePart::leg);
    std::vector<std::vector<SurfaceVertex>> rows;
    for (const LegRing& ring : rings) {
        auto& row = rows.emplace_back();
        double around = 0;
        for (std::size_t index = 0; index < outline.points.size(); ++index) {
            const Vec2& point = outline.points[index];
            const Vec2& normal = outline.normals[index];
            if (index > 0) {
                around += ring.size * (point - outline.points[index - 1]).length();
            }
            const Vec2 position = axis + ring.size * point;
            // The size of a square is measured across its sides.
            row.push_back({{position.x, position.y, floor + ring.height},
                           Vec3(normal.x, normal.y, -ring.slope * point.dot(normal)).normalized(),
                           {ring.height, around}});
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
    Surface leg = std::move(builder).finish();
    // The grain's direction is the material's.
    leg.board = Board{{axis.x, axis.y, 0.05 * axis.x - 0.1}, {1, 0, 0}};
    return leg;
}

/// The closed outline in four parts, which meet in the middles of its corners: front, right, back
/// and left.
std::vector<PlanPath> sides_of(const PlanPath& closed) {
    std::vector<std::size_t> corners;  // front right, back right, back left, front left
    for (const Vec2& diagonal : {Vec2(1, -1), Vec2(1, 1), Vec2(-1, 1), Vec2(-1, -1)}) {
        const auto nearness = [&](const PathPoint& point) {
            return point.normal_out.dot(diagonal);
        };
        const auto nearest = std::ranges::max_element(closed, {}, nearness);
        corners.push_back(static_cast<std::size_t>(nearest - closed.begin()));
    }
    // The outline begins in the middle of the front and ends there.
    PlanPath front(closed.begin() + static_cast<std::ptrdiff_t>(corners[3]), closed.end() - 1);
    front.insert(front.end(), closed.begin(),
                 closed.begin() + static_cast<std::ptrdiff_t>(corners[0]) + 1);
    std::vector<PlanPath> sides{front};
    for (std::size_t side = 0; side < 3; ++side) {
        sides.emplace_back(closed.begin() + static_cast<std::ptrdiff_t>(corners[side]),
                           closed.begin() + static_cast<std::ptrdiff_t>(corners[side + 1]) + 1);
    }
    return sides;
}

/// The number of gaps between the legs of a long side.
int leg_gaps(const TableMeasures& measures, double half_length) {
    // A table of 12 ft has eight legs.
    const double longest = build_of(measures) == TableBuild::snooker ? kSnookerLegGap : kLegGap;
    return std::max(1, static_cast<int>(std::floor(2 * half_length / longest)));
}

}  // namespace

std::vector<Surface> draw_apron(const TableLayout& layout) {
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
    std::vector<Surface> boards;
    for (const PlanPath& whole : sides_of(outer_path(layout))) {
        PlanPath path = thinned(whole);
        for (const bool is_end : {false, true}) {
            PathPoint& end = is_end ? path.back() : path.front();
            const PathPoint& next = is_end ? path[path.size() - 2] : path[1];
            end.position += kJoint * (next.position - end.position).normalized();
            end.tip += kJoint * (next.position - end.position).normalized();
        }
        SurfaceBuilder builder(fmt::format("apron_{}", boards.size() + 1), SurfacePart::apron);
        for (std::size_t index = 0; index < positions.size(); ++index) {
            builder.sweep(path, straight_profile(positions[index],
                                                 positions[(index + 1) % positions.size()]));
        }
        const SideFrame& side = layout.sides[boards.size()];
        Surface board = std::move(builder).finish();
        board.board = board_of(side.at(0, 0), side.along, boards.size() + 20);
        boards.push_back(std::move(board));
    }
    return boards;
}

std::vector<Surface> draw_legs(const TableLayout& layout) {
    const Vec2 leg_extent = layout.outer - Vec2(kLegInset);
    const double floor = -layout.measures.height;
    const double height = apron_bottom(layout.measures) + kLegInside - floor;
    const int gaps = leg_gaps(layout.measures, leg_extent.x);
    const bool is_turned = build_of(layout.measures) == TableBuild::snooker;
    const LegOutline outline = is_turned ? round_outline() : square_outline();
    const std::vector<LegRing> rings = is_turned ? turned_rings(height) : post_rings(height);
    std::vector<Surface> legs;
    for (int row = 0; row < 2; ++row) {
        for (int gap = 0; gap <= gaps; ++gap) {
            // One pair of legs at each end, the others evenly spaced between them.
            const Vec2 axis(-leg_extent.x + 2 * leg_extent.x * gap / gaps,
                            row == 0 ? -leg_extent.y : leg_extent.y);
            legs.push_back(
                draw_leg(fmt::format("leg_{}", legs.size() + 1), axis, floor, rings, outline));
        }
    }
    return legs;
}

}  // namespace carom::sim::billiards
