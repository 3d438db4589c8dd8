#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/elementary.h"
#include "sim/billiards/parts.h"
#include "sim/billiards/surface_builder.h"

namespace carom::sim::billiards {

namespace {

constexpr double kBottom = -0.001;      // z, under the cloth, m
constexpr double kNoseRadius = 0.0025;  // of the rounding above the nose, seen from the end, m
constexpr double kTopSpacing = 0.035;   // m

/// The cross-section of a cushion: an undercut face up to the nose, which is the foremost line; a
/// rounding above it; and a straight top back to the rail.
class CushionSection {
  public:
    CushionSection(const TableLayout& layout, const SideFrame& side)
        : measures_(layout.measures),
          side_(side),
          undercut_(layout.undercut),
          radius_(std::min(kNoseRadius, 0.7 * (measures_.rail_height - measures_.nose_height))),
          slope_((measures_.rail_height - measures_.nose_height - radius_) /
                 (measures_.cushion_width - radius_)) {}

    [[nodiscard]] double radius() const { return radius_; }

    [[nodiscard]] double inside_at_bottom() const { return undercut()[0].inside; }

    [[nodiscard]] double top_at(const Vec2& position) const {
        const double d = (position - side_.origin).dot(side_.outward);
        if (d >= measures_.cushion_width - 1e-9) {
            return measures_.rail_height;
        }
        return measures_.nose_height + radius_ + slope_ * (d - radius_);
    }

    [[nodiscard]] Vec3 top_normal() const {
        return Vec3(-slope_ * side_.outward.x, -slope_ * side_.outward.y, 1).normalized();
    }

    // From the bottom up to the nose.
    [[nodiscard]] Profile undercut() const {
        constexpr int kRows = 4;
        const SinCos lean = sin_cos(undercut_);
        const double open = lean.cos;
        const double up = -lean.sin;
        Profile profile;
        for (int row = 0; row <= kRows; ++row) {
            const double below = (measures_.nose_height - kBottom) * (kRows - row) / kRows;
            profile.push_back({below * tangent(undercut_), measures_.nose_height - below, open, up,
                               -below / open});
        }
        return profile;
    }

    // From the nose to the top, with the heights at the middle of a cushion.
    [[nodiscard]] Profile nose() const {
        constexpr int kSteps = 10;
        Profile profile;
        for (int step = 0; step <= kSteps; ++step) {
            const double angle = 0.5 * std::numbers::pi * step / kSteps;
            const SinCos at = sin_cos(angle);
            const double open = step == kSteps ? 0 : at.cos;
            const double up = at.sin;
            profile.push_back({radius_ * (1 - open), measures_.nose_height + radius_ * up, open, up,
                               radius_ * angle});
        }
        return profile;
    }

    /// The row of vertices at a profile point of the nose; at a jaw the rounding is stretched to
    /// the height of the top there.
    [[nodiscard]] std::vector<SurfaceVertex> nose_row(const PlanPath& path,
                                                      const ProfilePoint& point) const {
        const double fraction = (point.z - measures_.nose_height) / radius_;
        return row_along(path, point, [&](const PathPoint& path_point, SurfaceVertex& vertex) {
            if (fraction <= 0) {
                return;
            }
            const double top = top_at(path_point.inside(radius_));
            if (point.normal_open == 0) {
                vertex.position.z = top;
                vertex.normal = top_normal();
                return;
            }
            const double height = top - measures_.nose_height;
            vertex.position.z = measures_.nose_height + height * fraction;
            vertex.normal.x *= height / radius_;
            vertex.normal.y *= height / radius_;
            vertex.normal.normalize();
        });
    }

  private:
    const TableMeasures& measures_;
    SideFrame side_;
    double undercut_;
    double radius_;
    double slope_;
};

using Rows = std::vector<std::vector<SurfaceVertex>>;

// The column of vertices at one end of the swept rows, from bottom to top.
std::vector<Vec3> end_column(const Rows& undercut, const Rows& nose, bool is_end) {
    std::vector<Vec3> column;
    const auto add = [&](const std::vector<SurfaceVertex>& row) {
        const Vec3& position = (is_end ? row.back() : row.front()).position;
        if (column.empty() || column.back() != position) {
            column.push_back(position);
        }
    };
    for (const auto& row : undercut) {
        add(row);
    }
    for (const auto& row : nose) {
        add(row);
    }
    return column;
}

/// Builds the top, back, underside and mitred ends that close the swept face to a solid.
class CushionClosure {
  public:
    CushionClosure(SurfaceBuilder& builder, const CushionSection& section, const PlanPath& path,
                   const CushionLayout& cushion, const TableMeasures& measures)
        : builder_(builder),
          section_(section),
          path_(path),
          side_(cushion.side),
          rail_height_(measures.rail_height),
          from_is_mitred_(!cushion.jaw_from),
          to_is_mitred_(!cushion.jaw_to) {
        const double at_from = from_is_mitred_ ? measures.cushion_width : section.radius();
        const double at_to = to_is_mitred_ ? measures.cushion_width : section.radius();
        const Vec2 begin = path.front().inside(at_from);
        const Vec2 end = path.back().inside(at_to);
        const int count =
            std::max(1, static_cast<int>(std::ceil((end - begin).length() / kLongestStep)));
        for (int step = 0; step <= count; ++step) {
            back_line_.push_back(step == count ? end
                                               : begin + (end - begin) * (double(step) / count));
        }
    }

    void add_top() {
        Loop outline = inside_outline(path_, section_.radius());
        for (std::size_t index = back_line_.size(); index-- > 0;) {
            if (back_line_[index] != outline.front() && back_line_[index] != outline.back()) {
                outline.push_back(back_line_[index]);
            }
        }
        const Triangulation region = triangulate(std::span(&outline, 1), kTopSpacing);
        std::vector<std::uint32_t> ids;
        for (const Vec2& point : region.points) {
            const Vec2 local = point - side_.origin;
            ids.push_back(builder_.add({in_space(point, section_.top_at(point)),
                                        section_.top_normal(),
                                        {local.dot(side_.along), local.dot(side_.outward)}}));
        }
        for (const auto& [a, b, c] : region.triangles) {
            builder_.add_triangle(ids[a], ids[b], ids[c]);
        }
    }

    void add_back(const std::vector<Vec3>& from_column, const std::vector<Vec3>& to_column) {
        std::vector<Vec3> corners;
        if (from_is_mitred_) {
            corners.push_back(in_space(back_line_.front(), kBottom));
        } else {
            corners = from_column;
        }
        for (const Vec2& point : back_line_) {
            corners.push_back(in_space(point, rail_height_));
        }
        if (to_is_mitred_) {
            corners.push_back(in_space(back_line_.back(), kBottom));
        } else {
            corners.insert(corners.end(), to_column.rbegin(), to_column.rend());
        }
        corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
        builder_.add_polygon(corners, in_space(side_.outward, 0));
    }

    void add_underside() {
        Loop outline = inside_outline(path_, section_.inside_at_bottom());
        if (to_is_mitred_) {
            outline.push_back(back_line_.back());
        }
        if (from_is_mitred_) {
            outline.push_back(back_line_.front());
        }
        builder_.add_level(std::span(&outline, 1), kBottom, false, HUGE_VAL);
    }

    void add_mitre(const std::vector<Vec3>& column, bool is_end) {
        const Vec2 back = is_end ? back_line_.back() : back_line_.front();
        std::vector<Vec3> corners = column;
        corners.push_back(in_space(back, rail_height_));
        corners.push_back(in_space(back, kBottom));
        const Vec2 along = is_end ? side_.along : -side_.along;
        builder_.add_polygon(corners, in_space((along + side_.outward * -1.0).normalized(), 0));
    }

  private:
    SurfaceBuilder& builder_;
    const CushionSection& section_;
    const PlanPath& path_;
    SideFrame side_;
    double rail_height_;
    bool from_is_mitred_;
    bool to_is_mitred_;
    std::vector<Vec2> back_line_;
};

}  // namespace

PlanPath nose_path(const CushionLayout& cushion, double cushion_width) {
    const SideFrame& side = cushion.side;
    const Vec2 tip_from = side.at(cushion.from, 0);
    const Vec2 tip_to = side.at(cushion.to, 0);
    const auto end_of_from = [&](double d) {
        return side.at(cushion.from - cushion.jaw_from->end.x, d);
    };
    const auto end_of_to = [&](double d) { return side.at(cushion.to + cushion.jaw_to->end.x, d); };
    PathBuilder path(OpenSide::left, kLongestStep);
    Vec2 cut_from = side.outward - side.along;
    Vec2 cut_to = side.outward + side.along;
    if (cushion.jaw_from) {
        cut_from = side.along;
        path.start(end_of_from(cushion_width)).line_to(end_of_from(cushion.jaw_from->end.y));
        path.round(tip_from, cushion.lip_radius_from, tip_to);
    } else {
        path.start(tip_from);
    }
    if (cushion.jaw_to) {
        cut_to = side.along;
        const Vec2 jaw_end = end_of_to(cushion.jaw_to->end.y);
        path.round(tip_to, cushion.lip_radius_to, jaw_end);
        path.line_to(jaw_end).line_to(end_of_to(cushion_width));
    } else {
        path.line_to(tip_to);
    }
    return path.finish(cut_from, cut_to);
}

void add_faces(const CushionLayout& cushion, double cushion_width, TableGeometry& geometry) {
    const SideFrame& side = cushion.side;
    const auto add_face = [&](const Vec2& from, const Vec2& to, bool is_jaw) {
        const Vec2 span = to - from;
        if (span.length() > 1e-9) {
            geometry.faces.push_back({from, to, Vec2(-span.y, span.x).normalized(), is_jaw});
        }
    };
    const auto add_jaw = [&](const Jaw& jaw, double tip, double radius, double sign) {
        // From the rail to the lip for the first jaw of a cushion, reversed for the second.
        const SinCos turn = sin_cos(jaw.turn);
        const Vec2 lip = side.at(tip + sign * jaw.lip_tangent_length * turn.cos,
                                 jaw.lip_tangent_length * turn.sin);
        const Vec2 end = side.at(tip + sign * jaw.end.x, jaw.end.y);
        const Vec2 rail = side.at(tip + sign * jaw.end.x, cushion_width);
        if (sign < 0) {
            add_face(rail, end, true);
            add_face(end, lip, true);
        } else {
            add_face(lip, end, true);
            add_face(end, rail, true);
        }
        geometry.corners.push_back({side.at(tip - sign * jaw.lip_tangent_length, radius), radius});
    };
    double from = cushion.from;
    double to = cushion.to;
    if (cushion.jaw_from) {
        add_jaw(*cushion.jaw_from, from, cushion.lip_radius_from, -1);
        from += cushion.jaw_from->lip_tangent_length;
    }
    if (cushion.jaw_to) {
        to -= cushion.jaw_to->lip_tangent_length;
    }
    add_face(side.at(from, 0), side.at(to, 0), false);
    if (cushion.jaw_to) {
        add_jaw(*cushion.jaw_to, cushion.to, cushion.lip_radius_to, 1);
    }
}

Surface build_cushion(const TableLayout& layout, const CushionLayout& cushion,
                      const std::string& name) {
    const TableMeasures& measures = layout.measures;
    const CushionSection section(layout, cushion.side);
    const PlanPath path = nose_path(cushion, measures.cushion_width);
    SurfaceBuilder builder(name, SurfacePart::cushion);
    Rows undercut;
    for (const ProfilePoint& point : section.undercut()) {
        undercut.push_back(row_along(path, point));
    }
    Rows nose;
    for (const ProfilePoint& point : section.nose()) {
        nose.push_back(section.nose_row(path, point));
    }
    builder.add_grid(undercut);
    builder.add_grid(nose);

    const std::vector<Vec3> from_column = end_column(undercut, nose, false);
    const std::vector<Vec3> to_column = end_column(undercut, nose, true);
    CushionClosure closure(builder, section, path, cushion, measures);
    closure.add_top();
    closure.add_back(from_column, to_column);
    closure.add_underside();
    if (!cushion.jaw_from) {
        closure.add_mitre(from_column, false);
    }
    if (!cushion.jaw_to) {
        closure.add_mitre(to_column, true);
    }
    return std::move(builder).finish();
}

}  // namespace carom::sim::billiards
