#include "pipeline/picture/placed_shapes.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <type_traits>

#include "pipeline/picture/line_dashes.h"

namespace carom::pipeline {
namespace {

constexpr double kEdge = 0.0026;    // of lines, picture heights
constexpr double kLeastEdge = 0.7;  // pixels
constexpr double kHead = 4.2;       // length of an arrowhead, widths of its line
constexpr double kMostHead = 0.5;   // of the line's length

/// The parts of a line that are in front of the camera.
std::vector<StrongLine> cut_in_front(const StrongLine& line, const Pinhole& view) {
    std::vector<StrongLine> parts;
    StrongLine part;
    const auto depth = [&](const StrongPoint& point) {
        return view.depth(point.at) - 1.001 * Pinhole::kNearest;
    };
    for (std::size_t i = 0; i < line.size(); ++i) {
        const double here = depth(line[i]);
        const double before = i > 0 ? depth(line[i - 1]) : here;
        if (i > 0 && (here < 0) != (before < 0)) {
            const double u = before / (before - here);
            const StrongPoint& from = line[i - 1];
            part.push_back({from.at + u * (line[i].at - from.at),
                            from.strength + u * (line[i].strength - from.strength)});
        }
        if (here >= 0) {
            part.push_back(line[i]);
        } else if (!part.empty()) {
            parts.push_back(std::move(part));
            part.clear();
        }
    }
    if (!part.empty()) {
        parts.push_back(std::move(part));
    }
    return parts;
}

std::vector<Vec3> area_in_front(const std::vector<Vec3>& corners, const Pinhole& view) {
    std::vector<Vec3> kept;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec3& from = corners[i];
        const Vec3& to = corners[(i + 1) % corners.size()];
        const double before = view.depth(from) - 1.001 * Pinhole::kNearest;
        const double here = view.depth(to) - 1.001 * Pinhole::kNearest;
        if (before >= 0) {
            kept.push_back(from);
        }
        if ((before >= 0) != (here >= 0)) {
            kept.push_back(from + before / (before - here) * (to - from));
        }
    }
    return kept;
}

/// By Newell's method: also of an area that is not convex.
Vec3 normal_of(const std::vector<Vec3>& corners) {
    Vec3 normal(0);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        normal += corners[i].cross(corners[(i + 1) % corners.size()]);
    }
    return normal;
}

FittedText text_on(const SceneText& text, const Pinhole& view, Fonts& fonts) {
    const Vec2 picture = view.size();
    return fitted_text(fonts.of(text.font), text.text,
                       {text.size * picture.y, text.colour, text.box, TextAlign::centre},
                       room_on(picture));
}

/// The corner of a text that stays inside the picture while the place to which it belongs is there,
/// and leaves the picture with it.
Vec2 kept_inside(Vec2 corner, const Vec2& size, const Vec2& anchor, const Vec2& picture) {
    for (int axis = 0; axis < 2; ++axis) {
        const double beyond = anchor[axis] - std::clamp(anchor[axis], 0.0, picture[axis]);
        const double most = std::max(0.0, picture[axis] - size[axis]);
        corner[axis] = std::clamp(corner[axis] - beyond, 0.0, most) + beyond;
    }
    return corner;
}

class Placer {
  public:
    Placer(const Pinhole& view, Fonts& fonts) : view_(view), fonts_(fonts) {}

    void place(const SceneArea& area) {
        const std::vector<Vec3> corners = area_in_front(area.corners, view_);
        const Vec3 normal = normal_of(area.corners);
        const double distance =
            area.corners.empty() ? 0 : normal.dot(area.corners[0] - view_.position());
        if (corners.size() < 3 || distance == 0) {
            return;  // behind the camera, or seen from the side
        }
        PlacedArea placed;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const SeenPoint from = view_.project_straight(corners[i]);
            const SeenPoint to = view_.project_straight(corners[(i + 1) % corners.size()]);
            for (const PlacedPoint& point : bent({from.place}, {to.place})) {
                placed.corners.push_back(point.place);
            }
        }
        placed.colour = area.colour;
        placed.opacity = area.opacity;
        // normal . (depth * direction) = distance, and the direction is linear in the place without
        // distortion.
        placed.constant = normal.dot(view_.straight_direction({0, 0})) / distance;
        placed.slope =
            Vec2(normal.dot(view_.straight_direction({1, 0})) / distance - placed.constant,
                 normal.dot(view_.straight_direction({0, 1})) / distance - placed.constant);
        placed.bend = view_.bend();
        result.emplace_back(std::move(placed));
    }

    void place(const SceneLine& line) {
        for (const LineDash& dash : dashes_of(line, view_)) {
            PlacedLine look = plain_line(line.colour, line.width);
            look.width *= dash.thickness;
            look.is_round = dash.has_round_ends;
            for (const StrongLine& part : cut_in_front(dash.points, view_)) {
                const Vec3 beyond = part.back().at - dash.points.back().at;
                look.is_closed = dash.is_closed && part.size() == dash.points.size();
                look.head = dash.has_head && beyond.length() == 0 ? kHead * look.width : 0;
                add(part, look);
            }
        }
    }

    void place(const SceneDot& dot) {
        PlacedLine look = plain_line(dot.colour, dot.width);
        for (const StrongLine& part : cut_in_front({{dot.at, dot.strength}}, view_)) {
            add(part, look);
        }
    }

    void place(const SceneText& text) {
        const double depth = view_.depth(text.at);
        if (depth < 1.001 * Pinhole::kNearest || text.text.empty()) {
            return;
        }
        const double height = view_.size().y;
        DrawnText drawn = text_on(text, view_, fonts_).text;
        const Vec2 anchor = view_.project(text.at).place;
        const Vec2 centre = anchor + height * Vec2(text.offset.x, -text.offset.y);
        const Vec2 size = drawn.size();
        const Vec2 corner =
            kept_inside(centre - Vec2(0.5 * size.x, (text.is_above ? 1 : 0.5) * size.y), size,
                        anchor, view_.size());
        const double nearer = std::max(depth - text.nearer, Pinhole::kNearest);
        result.emplace_back(PlacedText{std::move(drawn), corner, 1 / nearer});
    }

    std::vector<PlacedShape> result;

  private:
    [[nodiscard]] PlacedLine plain_line(const Vec3& colour, double width) const {
        PlacedLine line;
        line.colour = colour;
        line.width = width * view_.size().y;
        line.edge = std::max(kLeastEdge, kEdge * view_.size().y);
        return line;
    }

    [[nodiscard]] PlacedPoint straight_place(const StrongPoint& point) const {
        const SeenPoint at = view_.project_straight(point.at);
        return {at.place, at.inverse_depth, point.strength};
    }

    /// A piece of a line from one place without distortion to the next, as the lens bends it: its
    /// points but the last.
    [[nodiscard]] std::vector<PlacedPoint> bent(const PlacedPoint& from,
                                                const PlacedPoint& to) const {
        constexpr double kLongest = 1.0 / 40;  // picture heights
        constexpr double kMost = 200;
        const PictureBend& bend = view_.bend();
        const double length = (to.place - from.place).length() / view_.size().y;
        const int pieces =
            bend.k == 0 ? 1
                        : static_cast<int>(std::ceil(std::clamp(length / kLongest, 1.0, kMost)));
        std::vector<PlacedPoint> points;
        for (int i = 0; i < pieces; ++i) {
            const double u = static_cast<double>(i) / pieces;
            points.push_back({bend.bent(from.place + u * (to.place - from.place)),
                              from.inverse_depth + u * (to.inverse_depth - from.inverse_depth),
                              from.strength + u * (to.strength - from.strength)});
        }
        return points;
    }

    void add(const StrongLine& points, PlacedLine line) {
        double length = 0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const bool is_last = i + 1 == points.size();
            const PlacedPoint from = straight_place(points[i]);
            const PlacedPoint to =
                is_last && !line.is_closed ? from : straight_place(points[(i + 1) % points.size()]);
            for (const PlacedPoint& at : bent(from, to)) {
                length += line.points.empty() ? 0 : (at.place - line.points.back().place).length();
                line.points.push_back(at);
            }
        }
        line.head = std::min(line.head, kMostHead * length);
        result.emplace_back(std::move(line));
    }

    const Pinhole& view_;
    Fonts& fonts_;
};

/// The box around places, with a margin around each.
struct Extent {
    Vec2 low{1e300, 1e300}, high{-1e300, -1e300};

    void include(const Vec2& place, double margin) {
        low = {std::min(low.x, place.x - margin), std::min(low.y, place.y - margin)};
        high = {std::max(high.x, place.x + margin), std::max(high.y, place.y + margin)};
    }
    void include(const PlacedArea& area) {
        for (const Vec2& corner : area.corners) {
            include(corner, 1);
        }
    }
    void include(const PlacedLine& line) {
        for (const PlacedPoint& point : line.points) {
            include(point.place, 0.5 * line.width + line.edge + line.head + 1);
        }
    }
    void include(const PlacedText& text) {
        include(text.corner, 1);
        include(text.corner + text.text.size(), 1);
    }
};

}  // namespace

std::vector<PlacedShape> placed_shapes(const SceneShapes& shapes, const Pinhole& view,
                                       Fonts& fonts) {
    Placer placer(view, fonts);
    for (const SceneShape& shape : shapes) {
        std::visit([&](const auto& s) { placer.place(s); }, shape);
    }
    return std::move(placer.result);
}

double scale_on(const SceneText& text, const Pinhole& view, Fonts& fonts) {
    return text_on(text, view, fonts).scale;
}

PixelBox box_of(std::span<const PlacedShape> shapes, const Vec2& picture) {
    Extent extent;
    for (const PlacedShape& shape : shapes) {
        std::visit([&](const auto& s) { extent.include(s); }, shape);
    }
    const auto pixel = [](double value, double size) {
        return static_cast<int>(std::clamp(value, 0.0, size));
    };
    return {pixel(std::floor(extent.low.x), picture.x), pixel(std::floor(extent.low.y), picture.y),
            pixel(std::ceil(extent.high.x), picture.x), pixel(std::ceil(extent.high.y), picture.y)};
}

}  // namespace carom::pipeline
