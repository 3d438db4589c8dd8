#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "sim/billiards/parts.h"
#include "sim/billiards/surface_builder.h"

namespace carom::sim::billiards {

namespace {

constexpr double kSeam = 0.0002;       // half of the gap between two pieces of wood, m
constexpr double kBlockMargin = 0.03;  // of wood beside a pocket's cut before the seam, m
constexpr double kInnerEdge = 0.0015;  // rounding beside cushion and pocket, m
constexpr double kLowerEdge = 0.004;   // rounding under the outer edge, m
constexpr double kTopSpacing = 0.05;   // m

double cut_radius(const PocketLayout& pocket) {
    return pocket.pocket.radius - kLinerInset + kLinerThickness;
}

Profile reversed(Profile profile) {
    std::reverse(profile.begin(), profile.end());
    return profile;
}

// Both run from the top to the underside.
std::vector<Profile> inner_profile(double top) {
    const ProfilePosition wall{0, top - kInnerEdge};
    return {reversed(round_profile(wall, {kInnerEdge, top})),
            straight_profile(wall, {0, kRailBottom})};
}

std::vector<Profile> outer_profile(double top, double edge) {
    const ProfilePosition wall{0, top - edge};
    const ProfilePosition foot{0, kRailBottom + kLowerEdge};
    return {reversed(round_profile(wall, {edge, top})), straight_profile(wall, foot),
            round_profile(foot, {kLowerEdge, kRailBottom})};
}

Surface build_piece(const WoodPiece& piece, double top, double edge) {
    SurfaceBuilder builder(piece.name, SurfacePart::rail);
    const std::vector<Profile> inner = inner_profile(top);
    const std::vector<Profile> outer = outer_profile(top, edge);
    for (const Profile& profile : inner) {
        builder.sweep(piece.inner, profile);
    }
    for (const Profile& profile : outer) {
        builder.sweep(piece.outer, profile);
    }

    const auto region = [&](double inner_inside, double outer_inside) {
        Loop loop = inside_outline(piece.inner, inner_inside);
        const Loop back = inside_outline(piece.outer, outer_inside);
        loop.insert(loop.end(), back.rbegin(), back.rend());
        return loop;
    };
    const Loop on_top = region(kInnerEdge, edge);
    const Loop below = region(0, kLowerEdge);
    builder.add_level(std::span(&on_top, 1), top, true, kTopSpacing, piece.grain);
    builder.add_level(std::span(&below, 1), kRailBottom, false, kTopSpacing, piece.grain);

    const auto add_end = [&](const PathPoint& inner_end, const PathPoint& outer_end,
                             const Vec2& facing) {
        std::vector<Vec3> section = profile_at(inner_end, inner);
        const std::vector<Vec3> back = profile_at(outer_end, outer);
        section.insert(section.end(), back.rbegin(), back.rend());
        builder.add_polygon(section, {facing.x, facing.y, 0});
    };
    add_end(piece.inner.front(), piece.outer.front(), piece.facing_back);
    add_end(piece.inner.back(), piece.outer.back(), piece.facing_ahead);
    return std::move(builder).finish();
}

const PocketLayout* find_pocket(const TableLayout& layout, const Vec2& axis) {
    for (const PocketLayout& pocket : layout.pockets) {
        if (pocket.axis.dot(axis) > 0.99) {
            return &pocket;
        }
    }
    return nullptr;
}

/// Builds the pieces of wood, side by side.
class Frame {
  public:
    explicit Frame(const TableLayout& layout)
        : layout_(layout),
          inner_(layout.measures.cushion_width),
          outer_(inner_ + layout.measures.rail_width) {}

    [[nodiscard]] std::vector<WoodPiece> pieces() {
        for (std::size_t index = 0; index < 4; ++index) {
            const SideFrame& side = layout_.sides[index];
            const double end = side.half_length + inner_ - corner_extent(index);
            const double begin = -side.half_length - inner_ + corner_extent((index + 3) % 4);
            const PocketLayout* pocket = find_pocket(layout_, side.outward);
            if (pocket == nullptr) {
                add_rail(side, begin, end);
            } else {
                const double half = cut_in_rail(layout_, *pocket, side, true) + kBlockMargin;
                add_rail(side, begin, -half);
                add_side_block(side, *pocket, half);
                add_rail(side, half, end);
            }
            add_corner_block(index);
        }
        return std::move(pieces_);
    }

  private:
    // Distance from the rails' inner corner, along both sides, to the seams of the corner block.
    [[nodiscard]] double corner_extent(std::size_t index) const {
        const SideFrame& side = layout_.sides[index];
        const Vec2 axis = (side.outward + layout_.sides[(index + 1) % 4].outward).normalized();
        const PocketLayout* pocket = find_pocket(layout_, axis);
        if (pocket == nullptr) {
            return kBlockMargin;
        }
        return side.half_length + inner_ - cut_in_rail(layout_, *pocket, side, false) +
               kBlockMargin;
    }

    void add(WoodPiece piece) {
        piece.name += fmt::format("{}", pieces_.size() + 1);
        pieces_.push_back(std::move(piece));
    }

    void add_rail(const SideFrame& side, double begin, double end) {
        const auto path = [&](OpenSide open_side, double d) {
            return PathBuilder(open_side, kLongestStep)
                .start(side.at(begin + kSeam, d))
                .line_to(side.at(end - kSeam, d))
                .finish();
        };
        add({"rail_", path(OpenSide::left, inner_), path(OpenSide::right, outer_), side.along,
             -side.along, side.along, false});
    }

    void add_side_block(const SideFrame& side, const PocketLayout& pocket, double half) {
        const Vec2 enter = side.at(cut_in_rail(layout_, pocket, side, false), inner_);
        const Vec2 leave = side.at(cut_in_rail(layout_, pocket, side, true), inner_);
        const PlanPath inner = PathBuilder(OpenSide::left, kLongestStep)
                                   .start(side.at(-half + kSeam, inner_))
                                   .line_to(enter)
                                   .arc_to(leave, pocket.pocket.centre, true)
                                   .line_to(side.at(half - kSeam, inner_))
                                   .finish();
        const PlanPath outer = PathBuilder(OpenSide::right, kLongestStep)
                                   .start(side.at(-half + kSeam, outer_))
                                   .line_to(side.at(half - kSeam, outer_))
                                   .finish();
        add({"rail_block_", inner, outer, side.along, -side.along, side.along, true});
    }

    void add_corner_block(std::size_t index) {
        const SideFrame& side = layout_.sides[index];
        const SideFrame& next = layout_.sides[(index + 1) % 4];
        const double extent = corner_extent(index) - kSeam;
        const double begin = side.half_length + inner_ - extent;
        const double end = -next.half_length - inner_ + extent;
        PathBuilder inner(OpenSide::left, kLongestStep);
        inner.start(side.at(begin, inner_));
        if (const auto* pocket = find_pocket(layout_, (side.outward + next.outward).normalized())) {
            inner.line_to(side.at(cut_in_rail(layout_, *pocket, side, false), inner_));
            inner.arc_to(next.at(cut_in_rail(layout_, *pocket, next, true), inner_),
                         pocket->pocket.centre, true);
        } else {
            inner.line_to(side.at(side.half_length + inner_, inner_));
        }
        inner.line_to(next.at(end, inner_));
        const bool has_pocket =
            find_pocket(layout_, (side.outward + next.outward).normalized()) != nullptr;
        const PlanPath outer = PathBuilder(OpenSide::right, kLongestStep)
                                   .start(side.at(begin, outer_))
                                   .round(side.at(side.half_length + outer_, outer_),
                                          outer_corner_radius(layout_), next.at(end, outer_))
                                   .line_to(next.at(end, outer_))
                                   .finish();
        add({"rail_block_", inner.finish(), outer, {1, 0}, -side.along, next.along, has_pocket});
    }

    const TableLayout& layout_;
    double inner_;
    double outer_;
    std::vector<WoodPiece> pieces_;
};

}  // namespace

double cut_in_rail(const TableLayout& layout, const PocketLayout& pocket, const SideFrame& side,
                   bool is_end) {
    const Vec2 centre = pocket.pocket.centre - side.origin;
    const double deep = layout.measures.cushion_width - centre.dot(side.outward);
    const double radius = cut_radius(pocket);
    const double half = std::sqrt(std::max(0.0, radius * radius - deep * deep));
    return centre.dot(side.along) + (is_end ? half : -half);
}

double outer_corner_radius(const TableLayout& layout) {
    return 0.45 * layout.measures.rail_width;
}

PlanPath outer_path(const TableLayout& layout) {
    const double radius = outer_corner_radius(layout);
    const Vec2 h = layout.outer;
    return PathBuilder(OpenSide::right, kLongestStep)
        .start({0, -h.y})
        .round({h.x, -h.y}, radius, {h.x, h.y})
        .round({h.x, h.y}, radius, {-h.x, h.y})
        .round({-h.x, h.y}, radius, {-h.x, -h.y})
        .round({-h.x, -h.y}, radius, {0, -h.y})
        .finish_closed();
}

std::vector<WoodPiece> wood_pieces(const TableLayout& layout) {
    return Frame(layout).pieces();
}

double outer_edge_radius(const TableMeasures& measures, double top) {
    return std::min(0.16 * measures.rail_width, 0.6 * (top - kRailBottom));
}

std::vector<Surface> build_rails(const TableLayout& layout) {
    const double top = layout.measures.rail_height;
    const double edge = outer_edge_radius(layout.measures, top);
    std::vector<Surface> surfaces;
    for (const WoodPiece& piece : wood_pieces(layout)) {
        surfaces.push_back(build_piece(piece, top, edge));
    }
    return surfaces;
}

}  // namespace carom::sim::billiards
