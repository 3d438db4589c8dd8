#include "pipeline/picture/text_drawing.h"

#include "pipeline/picture/colours.h"

namespace carom::pipeline {
namespace {

// In heights of a line.
constexpr double kEdge = 0.13;
constexpr double kSide = 0.4;  // between box and letters
constexpr double kTop = 0.18;
constexpr double kRound = 0.25;

constexpr double kMargin = 0.035;  // from the picture's edges, picture heights

}  // namespace

DrawnText::DrawnText(const Font& font, const std::string& text, const TextLook& look)
    : letters_(font.lay_out(text, look.line_height, look.align)), look_(look) {}

Vec2 DrawnText::margin() const {
    return look_.box.opacity > 0 ? look_.line_height * Vec2(kSide, kTop)
                                 : look_.line_height * Vec2(kEdge);
}

Vec2 DrawnText::size() const {
    return letters_.size() + 2.0 * margin();
}

void DrawnText::draw(cairo_t* context, const Vec2& corner) const {
    const SavedState state(context);
    cairo_new_path(context);
    const bool has_box = look_.box.opacity > 0;
    if (has_box) {
        add_round_box(context, corner, size(), kRound * look_.line_height);
        set_colour(context, look_.box.colour, look_.box.opacity);
        cairo_fill(context);
    }
    letters_.add_outlines(context, corner + margin());
    if (!has_box) {
        set_colour(context, casing_colour(), 0.85);
        cairo_set_line_join(context, CAIRO_LINE_JOIN_ROUND);
        cairo_set_line_width(context, 2 * kEdge * look_.line_height);
        cairo_stroke_preserve(context);
    }
    set_colour(context, look_.colour, 1);
    cairo_fill(context);
}

FittedText fitted_text(const Font& font, const std::string& text, TextLook look, const Vec2& room) {
    FittedText fitted{{font, text, look}, 1};
    const double line_height = look.line_height;
    const auto fits = [&] {
        const Vec2 size = fitted.text.size();
        return size.x <= room.x && size.y <= room.y;
    };
    constexpr double kStep = 0.97;  // a smaller text may also need fewer lines
    while (!fits()) {
        look.line_height = fitted.scale * line_height;
        const double width = room.x - 2 * fitted.text.margin().x;
        fitted.text = DrawnText(font, font.wrapped(text, look.line_height, width), look);
        if (fits() || fitted.scale * kStep < kLeastTextScale) {
            break;
        }
        fitted.scale *= kStep;
        look.line_height = fitted.scale * line_height;
        fitted.text = DrawnText(font, text, look);
    }
    return fitted;
}

Vec2 room_on(const Vec2& picture) {
    const Vec2 margin(kMargin * picture.y);
    return picture - 2.0 * margin;
}

Vec2 corner_at(const PicturePlace& place, const Vec2& size, const Vec2& picture) {
    if (!place.is_edge) {
        return place.at * picture - 0.5 * size;
    }
    const Vec2 margin(kMargin * picture.y);
    return margin + place.at * (picture - 2.0 * margin - size);
}

TextAlign alignment_at(const PicturePlace& place) {
    if (!place.is_edge || place.at.x == 0.5) {
        return TextAlign::centre;
    }
    return place.at.x < 0.5 ? TextAlign::left : TextAlign::right;
}

}  // namespace carom::pipeline
