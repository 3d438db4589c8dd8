#include "sim/billiards/layout.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/elementary.h"

namespace carom::sim::billiards {

namespace {

constexpr double kPi = std::numbers::pi;

// Distance of the nose in front of the line that the ball's foremost point touches: the nose
// touches the ball above its centre.
double nose_inset(double nose_height, double ball_radius) {
    const double above = nose_height - ball_radius;
    return ball_radius - std::sqrt(std::max(0.0, ball_radius * ball_radius - above * above));
}

// The back draft that the WPA specifies for a pocket's facing (12 to 15 degrees; Tournament Table
// and Equipment Specifications, section 9), and at least enough for a ball to touch the
// nose before the face.
double undercut(double nose_height, double ball_radius) {
    const double contact_angle = arcsine(std::clamp(nose_height / ball_radius - 1, 0.0, 0.9));
    return std::max(14 * kPi / 180, contact_angle + 0.5 * kPi / 180);
}

std::array<SideFrame, 4> side_frames(const Vec2& nose) {
    return {{{{0, -nose.y}, {1, 0}, {0, -1}, nose.x},
             {{nose.x, 0}, {0, 1}, {1, 0}, nose.y},
             {{0, nose.y}, {-1, 0}, {0, 1}, nose.x},
             {{-nose.x, 0}, {0, -1}, {-1, 0}, nose.y}}};
}

PocketLayout place_pocket(const std::string& name, const PocketMeasures& measures,
                          const Vec2& mouth, const Vec2& axis, bool is_corner) {
    const Vec2 centre = mouth + (measures.shelf + measures.hole_radius) * axis;
    return {{name, centre, measures.hole_radius, measures.drop}, measures, mouth, axis, is_corner};
}

std::vector<PocketLayout> place_pockets(const TableLayout& layout) {
    std::vector<PocketLayout> pockets;
    const auto add_corner = [&](const char* name, double x, double y) {
        if (const auto& measures = layout.measures.corner_pocket) {
            const Vec2 axis = Vec2(x, y) * std::numbers::sqrt2 * 0.5;
            const Vec2 corner(x * layout.nose.x, y * layout.nose.y);
            pockets.push_back(
                place_pocket(name, *measures, corner - 0.5 * measures->mouth * axis, axis, true));
        }
    };
    const auto add_side = [&](const char* name, double y) {
        if (const auto& measures = layout.measures.side_pocket) {
            pockets.push_back(place_pocket(name, *measures, {0, y * layout.nose.y}, {0, y}, false));
        }
    };
    add_corner("corner_left_front", -1, -1);
    add_side("side_front", -1);
    add_corner("corner_right_front", 1, -1);
    add_corner("corner_right_back", 1, 1);
    add_side("side_back", 1);
    add_corner("corner_left_back", -1, 1);
    return pockets;
}

std::vector<CushionLayout> place_cushions(const TableLayout& layout) {
    const TableMeasures& measures = layout.measures;
    std::vector<CushionLayout> cushions;
    for (std::size_t index = 0; index < 4; ++index) {
        const SideFrame& side = layout.sides[index];
        CushionLayout whole;
        whole.side = side;
        whole.from = -side.half_length;
        whole.to = side.half_length;
        if (const auto& corner = measures.corner_pocket) {
            const double cut = corner->mouth * std::numbers::sqrt2 * 0.5;
            const Jaw jaw = jaw_of(*corner, true, measures.cushion_width);
            whole.from += cut;
            whole.to -= cut;
            whole.jaw_from = whole.jaw_to = jaw;
            whole.lip_radius_from = whole.lip_radius_to = corner->lip_radius;
        }
        const bool is_long = index % 2 == 0;
        if (!is_long || !measures.side_pocket) {
            cushions.push_back(whole);
            continue;
        }
        CushionLayout first = whole;
        CushionLayout second = whole;
        first.to = -0.5 * measures.side_pocket->mouth;
        second.from = 0.5 * measures.side_pocket->mouth;
        first.jaw_to = second.jaw_from =
            jaw_of(*measures.side_pocket, false, measures.cushion_width);
        first.lip_radius_to = second.lip_radius_from = measures.side_pocket->lip_radius;
        cushions.push_back(first);
        cushions.push_back(second);
    }
    return cushions;
}

}  // namespace

Jaw jaw_of(const PocketMeasures& pocket, bool is_corner, double cushion_width) {
    Jaw jaw;
    jaw.turn = kPi - pocket.jaw_angle;
    // The axis of a corner pocket is at 45 degrees to its cushions, that of a side pocket at 90.
    const double closing = (is_corner ? kPi / 4 : kPi / 2) - jaw.turn;
    const SinCos turn = sin_cos(jaw.turn);
    const double across = 2 * sin_cos(closing).sin;
    const double whole = cushion_width / turn.sin;
    jaw.length = whole;
    // Between parallel jaws the throat is everywhere, so their length is not limited by it.
    if (std::abs(across) > 2e-9) {
        jaw.length = std::min(whole, (pocket.mouth - pocket.throat) / across);
    }
    if (std::abs(jaw.length - whole) < 1e-9) {
        jaw.length = whole;
    }
    jaw.end = {jaw.length * turn.cos, jaw.length == whole ? cushion_width : jaw.length * turn.sin};
    jaw.lip_tangent_length = pocket.lip_radius * tangent(jaw.turn / 2);
    return jaw;
}

TableLayout make_layout(const TableMeasures& measures, double ball_radius) {
    TableLayout layout;
    layout.measures = measures;
    layout.ball_radius = ball_radius;
    layout.nose_inset = nose_inset(measures.nose_height, ball_radius);
    layout.undercut = undercut(measures.nose_height, ball_radius);
    layout.nose = Vec2(0.5 * measures.length, 0.5 * measures.width) - Vec2(layout.nose_inset);
    layout.rail = layout.nose + Vec2(measures.cushion_width);
    layout.outer = layout.rail + Vec2(measures.rail_width);
    layout.sides = side_frames(layout.nose);
    layout.pockets = place_pockets(layout);
    layout.cushions = place_cushions(layout);
    return layout;
}

}  // namespace carom::sim::billiards
