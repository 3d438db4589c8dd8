// What a shot draws over its finished frames: annotations, and then the overlay.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "pipeline/camera/frame_plan.h"
#include "pipeline/shot/shot.h"
#include "sim/timeline/timeline.h"

namespace carom::pipeline {

class AnnotationPainter;  // pipeline/picture/annotation_painter.h
struct DrawnPicture;
enum class DrawnAnnotations : int;

/// Neither frames in the store nor EXR files have it. For one thread at a time. A frame is given by
/// its layers (FilmSource::layers).
class FrameGraphics {
  public:
    /// Refers to both. `threads` that share the work; 0: one per processor; none: those of the
    /// caller's arena.
    FrameGraphics(const Shot& shot, const sim::Timeline& timeline, std::optional<int> threads);
    ~FrameGraphics();
    FrameGraphics(const FrameGraphics&) = delete;
    FrameGraphics& operator=(const FrameGraphics&) = delete;

    /// Whether anything is ever drawn.
    [[nodiscard]] bool is_empty() const;

    /// Reads fonts and pictures, so that a film does not fail at its first frame. Throws Error.
    void prepare();

    /// Draws on the display values of a picture (width * height * 3, from the top left). Throws
    /// Error.
    void draw(std::span<const PlannedFrame> layers, std::span<std::uint8_t> rgb, int width,
              int height);
    /// The same on the signal of the shot's videos, which is that of hdr10 if the shot has it.
    void draw(std::span<const PlannedFrame> layers, std::span<std::uint16_t> signal, int width,
              int height);
    /// Only annotations, for pictures on which the overlay could not be read.
    void draw_annotations(std::span<const PlannedFrame> layers, std::span<std::uint8_t> rgb,
                          int width, int height);
    /// Only annotations in the scene, for a view that is not the film's.
    void draw_in_scene(const PlannedFrame& frame, std::span<std::uint8_t> rgb, int width,
                       int height);

  private:
    struct Last;
    [[nodiscard]] AnnotationPainter& painter();
    [[nodiscard]] DrawnPicture paint(std::span<const PlannedFrame> layers, int width, int height,
                                     DrawnAnnotations which);
    [[nodiscard]] const DrawnPicture& annotations(std::span<const PlannedFrame> layers, int width,
                                                  int height);

    const Shot& shot_;
    const sim::Timeline& timeline_;
    std::optional<int> threads_;
    std::unique_ptr<AnnotationPainter> painter_;  // made for the first frame with annotations
    std::unique_ptr<Last> last_;  // drawn frame, because the studio shows the same one many times
};

}  // namespace carom::pipeline
