// Draws text with an edge or a box, and places things on the picture.
#pragma once

#include <string>

#include "pipeline/picture/annotation.h"
#include "pipeline/picture/canvas.h"
#include "pipeline/picture/font.h"

namespace carom::pipeline {

struct TextLook {
    double line_height = 0;  // pixels
    Vec3 colour{1, 1, 1};    // linear
    TextBox box;             // without one, the letters have a dark edge
    TextAlign align = TextAlign::left;
};

/// A text with its look. Its size includes the box.
class DrawnText {
  public:
    DrawnText(const Font& font, const std::string& text, const TextLook& look);

    [[nodiscard]] Vec2 size() const;  // pixels
    /// Between the letters and the box or the outer side of their edges, pixels.
    [[nodiscard]] Vec2 margin() const;
    void draw(cairo_t* context, const Vec2& corner) const;

  private:
    LaidText letters_;
    TextLook look_;
};

/// A text as it fits into a part of the picture.
struct FittedText {
    DrawnText text;
    double scale = 1;  // of the size that was asked for
};

/// Smallest scale of a text that does not fit.
inline constexpr double kLeastTextScale = 0.25;

/// The text with its lines broken between words and, if that is not enough, smaller, so that it
/// fits into `room` (pixels), unless it is too large at the smallest scale. A text that fits is as
/// it was written.
[[nodiscard]] FittedText fitted_text(const Font& font, const std::string& text, TextLook look,
                                     const Vec2& room);

/// The part of a picture inside its margins, pixels.
[[nodiscard]] Vec2 room_on(const Vec2& picture);

/// The upper left corner of something of this `size` at that place of the picture, pixels.
[[nodiscard]] Vec2 corner_at(const PicturePlace& place, const Vec2& size, const Vec2& picture);

/// Of a text at that place.
[[nodiscard]] TextAlign alignment_at(const PicturePlace& place);

}  // namespace carom::pipeline
