#include "pipeline/picture/tip_diagram.h"

#include <array>
#include <cstdint>
#include <numbers>

#include "core/elementary.h"
#include "pipeline/picture/colours.h"
#include "sim/stick/strike.h"

namespace carom::pipeline {
namespace {

constexpr double kBall = 0.4;    // its radius, in sizes of the diagram
constexpr double kTip = 0.2;     // radius of the tip's mark, in ball radii
constexpr double kFine = 0.008;  // of lines, in sizes
constexpr double kRaised = std::numbers::pi / 180;

constexpr std::uint32_t kChalk = 0x145cbf;
constexpr std::uint32_t kBallColour = 0xf7f2e6;
constexpr std::uint32_t kInk = 0x40454c;
constexpr std::uint32_t kWood = 0xe8bf80;

void draw_cross(cairo_t* context, const Vec2& centre, double radius) {
    cairo_move_to(context, centre.x - radius, centre.y);
    cairo_line_to(context, centre.x + radius, centre.y);
    cairo_move_to(context, centre.x, centre.y - radius);
    cairo_line_to(context, centre.x, centre.y + radius);
    set_colour(context, srgb_colour(kInk), 0.4);
    cairo_stroke(context);
}

void draw_limit(cairo_t* context, const Vec2& centre, double radius, double size) {
    const std::array<double, 2> dashes{0.03 * size, 0.02 * size};
    cairo_set_dash(context, dashes.data(), 2, 0);
    add_circle(context, centre, sim::kMiscueOffset * radius);
    set_colour(context, srgb_colour(kInk), 0.65);
    cairo_stroke(context);
    cairo_set_dash(context, nullptr, 0, 0);
}

/// The stick from the side, in the lower right corner.
void draw_elevation(cairo_t* context, double elevation, const Vec2& corner, double size) {
    const SinCos at = sin_cos(elevation);
    const Vec2 foot = corner + size * Vec2(0.7, 0.95);
    const double length = 0.26 * size;
    cairo_move_to(context, foot.x, foot.y);
    cairo_line_to(context, foot.x + length, foot.y);
    set_colour(context, Vec3(1), 0.7);
    cairo_stroke(context);
    cairo_move_to(context, foot.x, foot.y);
    cairo_line_to(context, foot.x + length * at.cos, foot.y - length * at.sin);
    cairo_set_line_width(context, 3.5 * kFine * size);
    cairo_set_line_cap(context, CAIRO_LINE_CAP_ROUND);
    set_colour(context, srgb_colour(kWood), 1);
    cairo_stroke(context);
}

}  // namespace

void draw_tip_diagram(cairo_t* context, const sim::Strike& strike,
                      const std::optional<Vec3>& colour, const Vec2& corner, double size) {
    const SavedState state(context);
    cairo_new_path(context);
    add_round_box(context, corner, Vec2(size), 0.08 * size);
    set_colour(context, TextBox{}.colour, TextBox{}.opacity);
    cairo_fill(context);
    const Vec2 centre = corner + 0.5 * Vec2(size);
    const double radius = kBall * size;
    add_circle(context, centre, radius);
    set_colour(context, srgb_colour(kBallColour), 1);
    cairo_fill(context);
    cairo_set_line_width(context, kFine * size);
    draw_cross(context, centre, radius);
    draw_limit(context, centre, radius, size);
    add_circle(context, centre + radius * Vec2(strike.tip.x, -strike.tip.y), kTip * radius);
    set_colour(context, colour.value_or(srgb_colour(kChalk)), 1);
    cairo_fill_preserve(context);
    set_colour(context, srgb_colour(kInk), 1);
    cairo_stroke(context);
    if (strike.elevation >= kRaised) {
        draw_elevation(context, strike.elevation, corner, size);
    }
}

}  // namespace carom::pipeline
