// How large texts in the scene are.
#pragma once

#include <memory>

#include "pipeline/picture/scene_shapes.h"

namespace carom::pipeline {

/// In picture heights.
struct TextExtent {
    Vec2 letters{0, 0};  // width of the longest line, and height of all lines
    Vec2 margin{0, 0};   // on each side, for the box or the letters' edges
};

class Fonts;

/// For one thread at a time.
class TextExtents {
  public:
    TextExtents();
    ~TextExtents();
    TextExtents(const TextExtents&) = delete;
    TextExtents& operator=(const TextExtents&) = delete;

    /// Throws Error if the font cannot be read.
    [[nodiscard]] TextExtent of(const SceneText& text);

  private:
    std::unique_ptr<Fonts> fonts_;
};

}  // namespace carom::pipeline
