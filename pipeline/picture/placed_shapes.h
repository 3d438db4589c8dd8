// Shapes of the scene as they are on the picture.
#pragma once

#include <span>
#include <variant>
#include <vector>

#include "pipeline/picture/picture_items.h"
#include "pipeline/picture/pinhole.h"
#include "pipeline/picture/scene_shapes.h"
#include "pipeline/picture/text_drawing.h"

namespace carom::pipeline {

/// A point of a line on the picture with its opacity.
struct PlacedPoint {
    Vec2 place{0, 0};          // pixels
    double inverse_depth = 0;  // 1/m
    double strength = 1;
};

/// A line with a dark edge, or a dot if it has one point.
struct PlacedLine {
    std::vector<PlacedPoint> points;
    Vec3 colour{1, 1, 1};  // linear
    double width = 1;      // pixels
    double edge = 0;       // on both sides, pixels
    bool is_closed = false;
    bool is_round = true;  // its ends
    double head = 0;       // length of the arrowhead at its last point, pixels; 0: none
};

struct PlacedArea {
    std::vector<Vec2> corners;  // pixels
    Vec3 colour{1, 1, 1};       // linear
    double opacity = 1;
    // 1/depth at a place, 1/m: constant + slope . bend.straight(place)
    double constant = 0;
    Vec2 slope{0, 0};
    PictureBend bend{};
};

struct PlacedText {
    DrawnText text;
    Vec2 corner{0, 0};  // pixels
    double inverse_depth = 0;
};

using PlacedShape = std::variant<PlacedArea, PlacedLine, PlacedText>;

/// A rectangle of pixels; `low` belongs to it, `high` does not.
struct PixelBox {
    int left = 0, top = 0, right = 0, bottom = 0;
    [[nodiscard]] bool is_empty() const { return left >= right || top >= bottom; }
};

/// The shapes in front of the camera. Lines that are dashed are several, parts behind the camera
/// are cut off. Throws Error if a font cannot be read.
[[nodiscard]] std::vector<PlacedShape> placed_shapes(const SceneShapes& shapes, const Pinhole& view,
                                                     Fonts& fonts);

/// The part of its size at which a text is drawn so that it fits on the picture. Throws as above.
[[nodiscard]] double scale_on(const SceneText& text, const Pinhole& view, Fonts& fonts);

/// The pixels of the picture that the shapes may cover.
[[nodiscard]] PixelBox box_of(std::span<const PlacedShape> shapes, const Vec2& picture);

}  // namespace carom::pipeline
