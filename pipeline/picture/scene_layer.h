// A part of the picture in which annotations in the scene are drawn with 4 x 4 samples per pixel.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "pipeline/picture/canvas.h"
#include "pipeline/picture/obstacles.h"
#include "pipeline/picture/pinhole.h"
#include "pipeline/picture/placed_shapes.h"

namespace carom::pipeline {

/// Samples have a colour, which Cairo draws, and a depth. Where a surface of the scene is nearer,
/// they are transparent; so a line that is half behind a ball has half of its coverage, and
/// nothing of its colour is beside the ball.
class SceneLayer {
  public:
    /// Draws the shapes in the pixels of `box`.
    SceneLayer(std::span<const PlacedShape> shapes, const PixelBox& box);

    /// Composes the samples that are not hidden with `opacity` over the picture. Threads of the
    /// caller's arena share the work.
    void compose(const Pinhole& view, const Obstacles& obstacles, double opacity,
                 Canvas& picture) const;

  private:
    static constexpr int kSide = 4;  // samples along a side of a pixel

    struct Sample {
        float inverse_depth = 0;  // 1/m; 0: nothing is there
        float strength = 1;
        float distance = 1e30F;  // from the middle of the line that it belongs to, samples
    };
    struct Colour {
        float blue = 0, green = 0, red = 0, alpha = 0;  // premultiplied, [0, 255]
    };

    [[nodiscard]] int columns() const { return kSide * (box_.right - box_.left); }
    [[nodiscard]] int rows() const { return kSide * (box_.bottom - box_.top); }
    [[nodiscard]] std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns()) +
               static_cast<std::size_t>(column);
    }
    /// From pixels of the picture to samples.
    [[nodiscard]] Vec2 sample_at(const Vec2& place) const {
        return double{kSide} * (place - Vec2(box_.left, box_.top));
    }
    /// The middle of a sample on the picture, pixels.
    [[nodiscard]] Vec2 place_of(int column, int row) const {
        return Vec2(box_.left, box_.top) + Vec2(column + 0.5, row + 0.5) / kSide;
    }

    void draw(const PlacedArea& area);
    void draw(const PlacedLine& line);
    void draw(const PlacedText& text);
    void draw_line(const PlacedLine& line, double width);
    void set_depth(const PlacedArea& area);
    void set_depth(const PlacedLine& line);
    void set_depth(const PlacedText& text);
    void set_depth_of_piece(const PlacedPoint& from, const PlacedPoint& to, double radius);

    /// Those of a pixel in which something is drawn.
    struct PixelSamples {
        std::array<std::size_t, std::size_t{kSide} * kSide> at{};  // indices
        std::size_t count = 0;
    };
    [[nodiscard]] PixelSamples drawn_samples(int x, int y,
                                             std::span<const std::uint32_t> pixels) const;
    [[nodiscard]] bool is_hidden(std::size_t at, const Pinhole& view,
                                 const Obstacles& obstacles) const;
    void remove_hidden(PixelSamples& samples, const Pinhole& view,
                       const Obstacles& obstacles) const;
    /// Of the pixel; what is not among the samples counts as transparent.
    [[nodiscard]] Colour mean_of(const PixelSamples& samples,
                                 std::span<const std::uint32_t> pixels) const;

    PixelBox box_;
    Canvas canvas_;
    std::vector<Sample> samples_;
};

}  // namespace carom::pipeline
