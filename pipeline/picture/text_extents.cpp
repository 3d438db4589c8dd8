#include "pipeline/picture/text_extents.h"

#include "pipeline/picture/picture_items.h"
#include "pipeline/picture/text_drawing.h"

namespace carom::pipeline {

TextExtents::TextExtents() : fonts_(std::make_unique<Fonts>()) {}

TextExtents::~TextExtents() = default;

TextExtent TextExtents::of(const SceneText& text) {
    constexpr double kLineHeight = 100;  // pixels; sizes are in proportion to it
    const DrawnText drawn(fonts_->of(text.font), text.text,
                          {kLineHeight, text.colour, text.box, TextAlign::centre});
    const double scale = text.size / kLineHeight;
    const Vec2 margin = drawn.margin();
    return {scale * (drawn.size() - 2.0 * margin), scale * margin};
}

}  // namespace carom::pipeline
