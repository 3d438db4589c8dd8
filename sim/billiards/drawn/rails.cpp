#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include <fmt/core.h>

#include "core/elementary.h"
#include "sim/billiards/drawn/drawn_parts.h"
#include "sim/billiards/drawn/profiles.h"
#include "sim/billiards/parts.h"
#include "sim/billiards/surface_builder.h"

namespace carom::sim::billiards {

namespace {

constexpr double kInnerEdge = 0.0009;     // rounding of the wood beside the cushion's groove, m
constexpr double kLowerEdge = 0.004;      // rounding under the outer edge, m
constexpr double kJointBevel = 0.0006;    // of boards where they meet, m
constexpr double kCastingBevel = 0.0010;  // of castings, m
constexpr double kCastingLip = 0.0050;    // rounding of a casting into its pocket, m
constexpr double kCastingProud = 0.0010;  // by which castings stand out from the wood, m
constexpr double kTopSpacing = 0.12;      // m
constexpr double kSeam = 0.0002;          // half of the gap of a mitred joint, m

/// A point of a section through a piece: on its inner or its outer outline.
struct SectionPoint {
    bool is_inner = true;
    ProfilePoint at;
};

using Section = std::vector<SectionPoint>;

void append(Section& section, bool is_inner, const Profile& profile) {
    for (const ProfilePoint& point : profile) {
        section.push_back({is_inner, point});
    }
}

Profile reversed(Profile profile) {
    std::reverse(profile.begin(), profile.end());
    return profile;
}

/// What the edges of a piece are like.
struct PieceEdges {
    double top = 0;    // z, m
    double inner = 0;  // roundings, m
    double outer = 0;
    double bevel = 0;  // at the ends
};

std::vector<Profile> inner_profiles(const PieceEdges& edges) {
    const ProfilePosition wall{0, edges.top - edges.inner};
    return {reversed(thinned(round_profile(wall, {edges.inner, edges.top}))),
            straight_profile(wall, {0, kRailBottom})};
}

std::vector<Profile> outer_profiles(const PieceEdges& edges) {
    const ProfilePosition wall{0, edges.top - edges.outer};
    const ProfilePosition foot{0, kRailBottom + kLowerEdge};
    return {reversed(round_profile(wall, {edges.outer, edges.top})), straight_profile(wall, foot),
            thinned(round_profile(foot, {kLowerEdge, kRailBottom}))};
}

/// Builds one board or casting: the edges swept along its outlines, a top with holes, an underside
/// and bevelled ends.
class PieceBuilder {
  public:
    PieceBuilder(SurfaceBuilder& builder, const WoodPiece& piece, const PieceEdges& edges)
        : builder_(builder),
          piece_(piece),
          edges_(edges),
          inner_(inner_profiles(edges)),
          outer_(outer_profiles(edges)) {}

    void build(std::span<const Loop> holes) {
        for (const Profile& profile : inner_) {
            builder_.sweep(piece_.inner, profile);
        }
        for (const Profile& profile : outer_) {
            builder_.sweep(piece_.outer, profile);
        }
        std::vector<Loop> top{region(edges_.inner, edges_.outer)};
        top.insert(top.end(), holes.begin(), holes.end());
        builder_.add_level(top, edges_.top, true, kTopSpacing, piece_.grain);
        const Loop below = region(0, kLowerEdge);
        builder_.add_level(std::span(&below, 1), kRailBottom, false, HUGE_VAL, piece_.grain);
        add_end(piece_.inner.front(), piece_.outer.front(), piece_.facing_back);
        add_end(piece_.inner.back(), piece_.outer.back(), piece_.facing_ahead);
    }

  private:
    [[nodiscard]] Loop region(double inner_inside, double outer_inside) const {
        Loop loop = inside_outline(piece_.inner, inner_inside);
        const Loop back = inside_outline(piece_.outer, outer_inside);
        loop.insert(loop.end(), back.rbegin(), back.rend());
        return loop;
    }

    /// From the inner underside over the top to the outer underside.
    [[nodiscard]] Section section() const {
        Section section;
        for (const Profile* profile : {&inner_[1], &inner_[0]}) {
            append(section, true, reversed(*profile));
        }
        for (const Profile& profile : outer_) {
            append(section, false, profile);
        }
        return section;
    }

    /// The bevel around an end, and the end itself.
    void add_end(const PathPoint& inner, const PathPoint& outer, const Vec2& facing) {
        constexpr int kSteps = 2;
        const Section section = this->section();
        const Vec3 ahead(facing.x, facing.y, 0);
        std::vector<std::vector<SurfaceVertex>> rings;
        std::vector<Vec3> rim;
        for (int step = 0; step <= kSteps; ++step) {
            const SinCos angle = sin_cos(0.5 * std::numbers::pi * step / kSteps);
            const double sunk = edges_.bevel * (step == kSteps ? 1 : 1 - angle.cos);
            const double out = edges_.bevel * (step == 0 ? 0 : angle.sin);
            std::vector<SurfaceVertex>& ring = rings.emplace_back();
            rim.clear();
            for (const SectionPoint& point : section) {
                const PathPoint& end = point.is_inner ? inner : outer;
                const Vec2 plane = end.inside(point.at.inside + sunk * point.at.normal_open);
                const Vec3 at(plane.x + out * facing.x, plane.y + out * facing.y,
                              point.at.z - sunk * point.at.normal_up);
                const Vec2& open = end.normal_out;
                const Vec3 surface(open.x * point.at.normal_open, open.y * point.at.normal_open,
                                   point.at.normal_up);
                const Vec3 normal = angle.cos * surface + angle.sin * ahead;
                ring.push_back({at, normal.normalized(), {point.at.length, out}});
                rim.push_back(at);
            }
        }
        builder_.add_grid(rings);
        builder_.add_polygon(rim, ahead);
    }

    SurfaceBuilder& builder_;
    const WoodPiece& piece_;
    PieceEdges edges_;
    std::vector<Profile> inner_;
    std::vector<Profile> outer_;
};

/// Shortens the ends of an outline by a length along it, less where its first pieces are short.
void shorten(PlanPath& path, double length) {
    const auto move = [&](PathPoint& end, const PathPoint& next) {
        const Vec2 piece = next.position - end.position;
        end.position += std::min(length, 0.3 * piece.length()) * piece.normalized();
    };
    move(path.front(), path[1]);
    move(path.back(), path[path.size() - 2]);
}

/// Four boards whose ends are mitred at the corners of the table.
std::vector<WoodPiece> mitred_boards(const TableLayout& layout) {
    std::vector<WoodPiece> boards;
    const double inner = layout.measures.cushion_width;
    const double outer = inner + layout.measures.rail_width;
    const double radius = outer_corner_radius(layout);
    for (const SideFrame& side : layout.sides) {
        const double corner = side.half_length + inner - kSeam;
        const double far = side.half_length + outer;
        // The middle of the rounded corner, and the centre of its rounding.
        const double middle = far - radius * (1 - std::numbers::sqrt2 / 2);
        const double d_middle = outer - radius * (1 - std::numbers::sqrt2 / 2);
        const double centre = far - radius;
        const Vec2 to_start = side.outward - side.along;
        const Vec2 to_end = side.outward + side.along;
        WoodPiece board;
        board.name = fmt::format("rail_{}", boards.size() + 1);
        board.inner = PathBuilder(OpenSide::left, kLongestStep)
                          .start(side.at(-corner, inner))
                          .line_to(side.at(corner, inner))
                          .finish(to_start, to_end);
        board.outer =
            PathBuilder(OpenSide::right, kLongestStep)
                .start(side.at(-middle + kSeam, d_middle))
                .arc_to(side.at(-centre, outer), side.at(-centre, outer - radius), true)
                .line_to(side.at(centre, outer))
                .arc_to(side.at(middle - kSeam, d_middle), side.at(centre, outer - radius), true)
                .finish(to_start * -1.0, to_end * -1.0);
        board.grain = side.along;
        board.facing_back = (side.along * -1.0 - side.outward).normalized();
        board.facing_ahead = (side.along - side.outward).normalized();
        boards.push_back(std::move(board));
    }
    return boards;
}

double cross(const Vec2& a, const Vec2& b) {
    return a.x * b.y - a.y * b.x;
}

/// Whether a sight with this outline lies in the level top of a straight board, away from its
/// edges.
bool has_room(const WoodPiece& board, const PieceEdges& edges, const Loop& sight) {
    constexpr double kMargin = 0.002;
    const Vec2 inner = board.inner.front().inside(edges.inner + kMargin);
    const Vec2 outer = board.outer.front().inside(edges.outer + kMargin);
    const Vec2 along = board.grain;
    const Vec2 outwards(along.y, -along.x);
    const double begin = board.inner.front().position.dot(along) + kMargin;
    const double end = board.inner.back().position.dot(along) - kMargin;
    return std::ranges::all_of(sight, [&](const Vec2& corner) {
        return cross(along, corner - inner) < 0 && cross(along, corner - outer) > 0 &&
               corner.dot(along) > begin && corner.dot(along) < end;
    });
}

}  // namespace

DrawnRails draw_rails(const TableLayout& layout) {
    const TableMeasures& measures = layout.measures;
    const TableBuild build = build_of(measures);
    const double top = drawn_rail_top(measures);
    const double outer = outer_edge_radius(measures, top);
    const PieceEdges wood{top, kInnerEdge, outer, kJointBevel};
    const PieceEdges metal{top + kCastingProud, kCastingLip, outer + kCastingProud, kCastingBevel};
    const std::vector<Loop> sights = sight_outlines(layout);
    SurfaceBuilder inlaid("sights", SurfacePart::sight);
    DrawnRails rails;
    std::vector<WoodPiece> pieces =
        build == TableBuild::carom ? mitred_boards(layout) : wood_pieces(layout);
    for (WoodPiece& piece : pieces) {
        const bool is_casting = piece.has_pocket && build == TableBuild::pool;
        const PieceEdges& edges = is_casting ? metal : wood;
        piece.inner = thinned(piece.inner);
        piece.outer = thinned(piece.outer);
        shorten(piece.inner, edges.bevel);
        shorten(piece.outer, edges.bevel);
        std::vector<Loop> holes;
        const bool is_straight = !piece.has_pocket && piece.name.starts_with("rail_") &&
                                 !piece.name.starts_with("rail_block_");
        for (const Loop& sight : sights) {
            if (is_straight && has_room(piece, edges, sight)) {
                holes.push_back(sight);
                inlaid.add_level(std::span(&sight, 1), top, true, HUGE_VAL, piece.grain);
                ++rails.sight_count;
            }
        }
        SurfaceBuilder builder(piece.name, is_casting ? SurfacePart::casting : SurfacePart::rail);
        PieceBuilder(builder, piece, edges).build(holes);
        Surface surface = std::move(builder).finish();
        if (!is_casting) {
            const Vec2 middle = 0.5 * (piece.inner.front().position + piece.outer.back().position);
            surface.board = board_of(middle, piece.grain, rails.surfaces.size());
        }
        rails.surfaces.push_back(std::move(surface));
    }
    if (rails.sight_count > 0) {
        rails.surfaces.push_back(std::move(inlaid).finish());
    }
    return rails;
}

Board board_of(const Vec2& middle, const Vec2& grain, std::size_t number) {
    // Far apart along the trunk, and at different places across it.
    const auto part = [&](double step) {
        const double place = step * static_cast<double>(number + 1);
        return place - std::floor(place);
    };
    const Vec2 across(-grain.y, grain.x);
    const Vec2 origin = middle - (0.9 * static_cast<double>(number)) * grain -
                        (0.06 * (part(0.6180339887) - 0.5)) * across;
    return {{origin.x, origin.y, -0.03 * part(0.7548776662)}, {grain.x, grain.y, 0}};
}

}  // namespace carom::sim::billiards
