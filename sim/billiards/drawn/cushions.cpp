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

constexpr double kDegree = std::numbers::pi / 180;
// WPA, Tournament Table and Equipment Specifications, section 9: the facing leans back by 12 to 15
// degrees.
constexpr double kBackDraft = 13.5 * kDegree;
constexpr double kFacingEdge = 0.0011;  // rounding of the cloth between cushion and facing, m
constexpr double kMitreEdge = 0.0005;   // likewise where two cushions meet, m
constexpr double kRoundJaw = 0.010;     // from this lip radius on the rubber runs round the jaw, m
constexpr double kLongestPiece = 0.2;   // along a cushion, m
constexpr int kEdgeSteps = 4;

/// One end of a cushion that is cut, in its side's frame.
struct CutEnd {
    double tip = 0;    // u of the corner of nose and jaw
    double sign = 1;   // +1: the end at larger u
    Vec2 jaw{1, 1};    // from the tip to the jaw's end, towards the pocket and outwards
    double draft = 0;  // tangent of the facing's lean
    double edge = 0;   // m
    double nose_height = 0;
    bool is_mitred = false;

    [[nodiscard]] double turn_sine() const { return jaw.y / jaw.length(); }

    /// u of the facing at a distance from the nose line and a height.
    [[nodiscard]] double at(double d, double z) const {
        const double reach = jaw.x * std::min(1.0, d / jaw.y);
        const double back = draft * std::max(0.0, nose_height - z) / turn_sine();
        return tip + sign * (reach - back);
    }
    /// The facing's outward normal along u, outwards and up.
    [[nodiscard]] Vec3 normal(double d, double z) const {
        const Vec2 along = jaw.normalized();
        const bool is_straight = !is_mitred && d > jaw.y + 1e-9;
        const Vec2 flat = is_straight ? Vec2(1, 0) : Vec2(along.y, -along.x);
        return Vec3(sign * flat.x, flat.y, z < nose_height - 1e-6 ? -draft : 0).normalized();
    }
};

/// A point of a cushion's surface in its side's frame: u, d and height.
struct FramePoint {
    Vec3 at;
    Vec3 normal;
};

SurfaceVertex in_world(const SideFrame& side, const FramePoint& point, double along_profile) {
    const Vec2 at = side.at(point.at.x, point.at.y);
    const Vec2 normal = point.normal.x * side.along + point.normal.y * side.outward;
    return {{at.x, at.y, point.at.z},
            Vec3(normal.x, normal.y, point.normal.z).normalized(),
            {point.at.x, along_profile}};
}

/// A cushion whose ends are cut: at facings, or mitred.
class CutCushion {
  public:
    CutCushion(SurfaceBuilder& builder, const TableLayout& layout, const CushionLayout& cushion)
        : builder_(builder), side_(cushion.side) {
        const CushionProfile profile = cushion_profile(layout);
        profile_ = profile.front;
        profile_.insert(profile_.end(), profile.back.begin() + 1, profile.back.end());
        const TableMeasures& measures = layout.measures;
        begin_ = end_of(cushion.jaw_from, cushion.from, -1, measures);
        end_ = end_of(cushion.jaw_to, cushion.to, 1, measures);
    }

    void build() {
        std::vector<std::vector<SurfaceVertex>> columns;
        for (int step = kEdgeSteps; step >= 0; --step) {
            columns.push_back(edge_column(begin_, step));
        }
        const double from = begin_.tip + 0.03;
        const double to = end_.tip - 0.03;
        const int pieces = static_cast<int>(std::ceil((to - from) / kLongestPiece));
        for (int piece = 0; piece <= pieces && to > from; ++piece) {
            columns.push_back(column_at(from + (to - from) * piece / pieces));
        }
        for (int step = 0; step <= kEdgeSteps; ++step) {
            columns.push_back(edge_column(end_, step));
        }
        builder_.add_grid(columns);
        for (const CutEnd* end : {&begin_, &end_}) {
            if (!end->is_mitred) {
                add_facing(*end);
            }
        }
    }

  private:
    [[nodiscard]] static CutEnd end_of(const std::optional<Jaw>& jaw, double tip, double sign,
                                       const TableMeasures& measures) {
        CutEnd end;
        end.tip = tip;
        end.sign = sign;
        end.nose_height = measures.nose_height;
        end.is_mitred = !jaw;
        end.edge = jaw ? kFacingEdge : kMitreEdge;
        end.jaw = jaw ? jaw->end : Vec2(measures.cushion_width, measures.cushion_width);
        end.draft = jaw ? tangent(kBackDraft) : 0;
        return end;
    }

    /// How much of an edge's rounding a point of the profile has: none at the foot and in the
    /// groove.
    [[nodiscard]] double rounding_at(std::size_t index) const {
        const double foot = profile_[1].z;
        const double end = profile_.back().inside - kGrooveEdge;
        const ProfilePoint& point = profile_[index];
        const double above_foot = std::clamp((point.z - foot) / 0.004, 0.0, 1.0);
        const double before_end = std::clamp((end - point.inside) / 0.0025, 0.0, 1.0);
        return std::min(above_foot, before_end);
    }

    [[nodiscard]] FramePoint edge_point(const CutEnd& end, int step, std::size_t index) const {
        const ProfilePoint& point = profile_[index];
        const double edge = end.edge * rounding_at(index);
        const SinCos angle = sin_cos(0.5 * std::numbers::pi * step / kEdgeSteps);
        const double cosine = step == kEdgeSteps ? 0 : angle.cos;
        const double inside = edge * (1 - cosine);
        const double d = point.inside + inside * point.normal_open;
        const double z = point.z - inside * point.normal_up;
        const double u = end.at(d, z) - end.sign * edge * (1 - angle.sin);
        const Vec3 surface(0, -point.normal_open, point.normal_up);
        const Vec3 normal = cosine * surface + angle.sin * end.normal(d, z);
        return {{u, d, z}, edge > 0 ? normal.normalized() : surface};
    }

    [[nodiscard]] std::vector<SurfaceVertex> edge_column(const CutEnd& end, int step) const {
        std::vector<SurfaceVertex> column;
        for (std::size_t index = 0; index < profile_.size(); ++index) {
            column.push_back(in_world(side_, edge_point(end, step, index), profile_[index].length));
        }
        return column;
    }

    [[nodiscard]] std::vector<SurfaceVertex> column_at(double u) const {
        std::vector<SurfaceVertex> column;
        for (const ProfilePoint& point : profile_) {
            column.push_back(in_world(
                side_, {{u, point.inside, point.z}, {0, -point.normal_open, point.normal_up}},
                point.length));
        }
        return column;
    }

    /// The facing, in strips from the profile to the rail.
    void add_facing(const CutEnd& end) {
        const double back = profile_.back().inside;
        const auto vertex = [&](double d, double z) {
            const FramePoint corner{{end.at(d, z), d, z}, end.normal(d, z)};
            SurfaceVertex placed = in_world(side_, corner, z);
            placed.uv.x = d / end.turn_sine();  // along the jaw
            return placed;
        };
        std::vector<std::vector<SurfaceVertex>> rows;
        double highest = -1;
        for (std::size_t index = 0; index < profile_.size(); ++index) {
            const FramePoint point = edge_point(end, kEdgeSteps, index);
            if (point.at.z > highest + 1e-6 && point.at.y < back - 1e-6) {
                highest = point.at.z;
                rows.push_back({vertex(point.at.y, highest), vertex(back, highest)});
            }
        }
        builder_.add_grid(rows);
    }

    SurfaceBuilder& builder_;
    SideFrame side_;
    Profile profile_;
    CutEnd begin_;
    CutEnd end_;
};

/// A cushion whose rubber runs round its jaws.
class RoundCushion {
  public:
    RoundCushion(SurfaceBuilder& builder, const TableLayout& layout, const CushionLayout& cushion)
        : builder_(builder),
          side_(cushion.side),
          profile_(cushion_profile(layout)),
          width_(cloth_end(layout.measures) - kGrooveEdge),
          path_(outline(cushion)) {}

    void build() {
        std::vector<std::vector<SurfaceVertex>> rows;
        for (const ProfilePoint& point : profile_.front) {
            rows.push_back(row_along(path_, point, [&](const PathPoint&, SurfaceVertex& vertex) {
                keep_before_groove(vertex);
            }));
        }
        // The rest of the top is level, up to the groove.
        std::vector<SurfaceVertex> level = rows.back();
        for (SurfaceVertex& vertex : level) {
            const double u =
                (Vec2(vertex.position.x, vertex.position.y) - side_.origin).dot(side_.along);
            vertex = in_world(side_, {{u, width_, vertex.position.z}, {0, 0, 1}}, width_);
        }
        builder_.add_grid(rows);
        const std::array<std::vector<SurfaceVertex>, 2> top{rows.back(), level};
        builder_.add_grid(top);
        add_back(level.front(), level.back());
    }

  private:
    /// Jaw, nose and jaw, cut off along the groove.
    [[nodiscard]] PlanPath outline(const CushionLayout& cushion) const {
        const auto point_of = [&](const Jaw& jaw, double tip, double sign, double d) {
            return side_.at(tip + sign * jaw.end.x * std::min(1.0, d / jaw.end.y), d);
        };
        PathBuilder path(OpenSide::left, kLongestPiece);
        Vec2 cut_from = side_.outward - side_.along;
        Vec2 cut_to = side_.outward + side_.along;
        const Vec2 tip_from = side_.at(cushion.from, 0);
        const Vec2 tip_to = side_.at(cushion.to, 0);
        if (cushion.jaw_from) {
            cut_from = side_.along;
            path.start(point_of(*cushion.jaw_from, cushion.from, -1, width_));
            if (cushion.jaw_from->end.y < width_) {
                path.line_to(
                    point_of(*cushion.jaw_from, cushion.from, -1, cushion.jaw_from->end.y));
            }
            path.round(tip_from, cushion.lip_radius_from, tip_to);
        } else {
            path.start(tip_from);
        }
        if (cushion.jaw_to) {
            cut_to = side_.along;
            const double end = std::min(cushion.jaw_to->end.y, width_);
            path.round(tip_to, cushion.lip_radius_to,
                       point_of(*cushion.jaw_to, cushion.to, 1, end));
            path.line_to(point_of(*cushion.jaw_to, cushion.to, 1, end));
            path.line_to(point_of(*cushion.jaw_to, cushion.to, 1, width_));
        } else {
            path.line_to(tip_to);
        }
        return path.finish(cut_from, cut_to);
    }

    /// Behind a jaw's end there is no room for the whole profile.
    void keep_before_groove(SurfaceVertex& vertex) const {
        const Vec2 at(vertex.position.x, vertex.position.y);
        const double beyond = (at - side_.origin).dot(side_.outward) - width_;
        if (beyond > 0) {
            vertex.position.x -= beyond * side_.outward.x;
            vertex.position.y -= beyond * side_.outward.y;
        }
    }

    /// The cloth's edge along the groove, behind the level top.
    void add_back(const SurfaceVertex& from, const SurfaceVertex& to) {
        std::vector<std::vector<SurfaceVertex>> columns;
        for (const SurfaceVertex* end : {&from, &to}) {
            std::vector<SurfaceVertex>& column = columns.emplace_back();
            for (const ProfilePoint& point : profile_.back) {
                const double d = std::max(point.inside, width_);
                const Vec3 normal(0, -point.normal_open, point.normal_up);
                column.push_back(in_world(side_, {{end->uv.x, d, point.z}, normal}, point.length));
            }
        }
        builder_.add_grid(columns);
    }

    SurfaceBuilder& builder_;
    SideFrame side_;
    CushionProfile profile_;
    double width_;  // of the part in front of the groove's edge
    PlanPath path_;
};

}  // namespace

std::vector<Surface> draw_cushions(const TableLayout& layout) {
    std::vector<Surface> cushions;
    for (const CushionLayout& cushion : layout.cushions) {
        SurfaceBuilder builder(fmt::format("cushion_{}", cushions.size() + 1),
                               SurfacePart::cushion);
        if (std::max(cushion.lip_radius_from, cushion.lip_radius_to) >= kRoundJaw) {
            RoundCushion(builder, layout, cushion).build();
        } else {
            CutCushion(builder, layout, cushion).build();
        }
        cushions.push_back(std::move(builder).finish());
    }
    return cushions;
}

}  // namespace carom::sim::billiards
