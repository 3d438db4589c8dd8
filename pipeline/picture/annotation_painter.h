// Draws the annotations of a shot on finished frames.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "pipeline/camera/frame_plan.h"
#include "pipeline/shot/shot.h"
#include "sim/timeline/timeline.h"

namespace carom::pipeline {

/// A picture to compose over another: premultiplied and sRGB-encoded, 8 bits each, as 0xaarrggbb,
/// row by row from the top left.
struct DrawnPicture {
    int width = 0;  // pixels
    int height = 0;
    std::vector<std::uint32_t> pixels;
};

enum class DrawnAnnotations : int { all, in_scene };

/// Prepares what all frames share when it is needed: fonts, pictures, and the scene's geometry for
/// annotations that surfaces can hide. For one thread at a time.
class AnnotationPainter {
  public:
    /// Refers to both. `timeline`: of the shot, with its keyed motions.
    AnnotationPainter(const Shot& shot, const sim::Timeline& timeline);
    ~AnnotationPainter();
    AnnotationPainter(const AnnotationPainter&) = delete;
    AnnotationPainter& operator=(const AnnotationPainter&) = delete;

    /// Reads all fonts and pictures, so that a film does not fail at its first frame. Throws Error.
    void prepare();

    /// The annotations of a frame that consists of these layers (plan_mixed_frame), in the order of
    /// the shot: those in the scene first, then those on the picture. Empty if none is shown. The
    /// same arguments give the same pixels. Threads of the caller's arena share the work. Throws
    /// Error.
    [[nodiscard]] DrawnPicture draw(std::span<const PlannedFrame> layers, int width, int height,
                                    DrawnAnnotations which = DrawnAnnotations::all);

  private:
    class Painter;
    std::unique_ptr<Painter> painter_;
};

}  // namespace carom::pipeline
