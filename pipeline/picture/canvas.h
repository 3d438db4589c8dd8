// A transparent picture that Cairo draws on. Cairo's types stay in this folder.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include <cairo.h>

#include "core/vectors.h"

namespace carom::pipeline {

/// Pixels are premultiplied and sRGB-encoded, 8 bits each, as 0xaarrggbb, row by row from the top
/// left. At first they are transparent.
class Canvas {
  public:
    /// At least one pixel. Throws Error.
    Canvas(int width, int height);

    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }
    /// For drawing. Lengths are in pixels; antialiased.
    [[nodiscard]] cairo_t* context() const { return context_.get(); }
    /// The drawn pixels, until something is drawn again. Throws Error if drawing failed.
    [[nodiscard]] std::span<const std::uint32_t> pixels() const;
    /// The same for writing. Whoever has written must call changed().
    [[nodiscard]] std::span<std::uint32_t> pixels();
    void changed();

  private:
    struct Destroy {
        void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
        void operator()(cairo_t* context) const { cairo_destroy(context); }
    };

    int width_;
    int height_;
    std::unique_ptr<cairo_surface_t, Destroy> surface_;
    std::unique_ptr<cairo_t, Destroy> context_;
};

/// Keeps the context's state and restores it.
class SavedState {
  public:
    explicit SavedState(cairo_t* context) : context_(context) { cairo_save(context); }
    ~SavedState() { cairo_restore(context_); }
    SavedState(const SavedState&) = delete;
    SavedState& operator=(const SavedState&) = delete;

  private:
    cairo_t* context_;
};

/// The colour that is drawn with; `linear` Rec.709.
void set_colour(cairo_t* context, const Vec3& linear, double opacity);

/// Adds a rectangle with round corners to the path.
void add_round_box(cairo_t* context, const Vec2& corner, const Vec2& size, double radius);

/// Adds a circle to the path.
void add_circle(cairo_t* context, const Vec2& centre, double radius);

}  // namespace carom::pipeline
