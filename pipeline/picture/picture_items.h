// Annotations that have a place on the picture.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/camera/frame_plan.h"
#include "pipeline/picture/annotation.h"
#include "pipeline/picture/annotation_boxes.h"
#include "pipeline/picture/canvas.h"
#include "pipeline/picture/font.h"
#include "pipeline/picture/small_plan.h"
#include "pipeline/picture/text_drawing.h"
#include "pipeline/picture/values.h"
#include "pipeline/shot/shot.h"
#include "sim/timeline/timeline.h"

namespace carom::pipeline {

/// Fonts by file, each opened once. For one thread at a time.
class Fonts {
  public:
    /// The default font if `file` is empty. Throws Error.
    [[nodiscard]] const Font& of(const std::string& file);

  private:
    std::map<std::string, std::unique_ptr<Font>> fonts_;
};

/// The moment of a frame, for its texts.
[[nodiscard]] FrameMoment moment_of(const PlannedFrame& frame);

/// Draws these annotations. Refers to its arguments; for one thread at a time.
class PictureItems {
  public:
    PictureItems(const Shot& shot, const sim::Timeline& timeline, Fonts& fonts)
        : shot_(shot), timeline_(timeline), fonts_(fonts) {}

    /// Reads the picture of the annotation if it has one. Throws Error.
    void prepare(const Annotation& annotation);

    /// Draws the annotation with full opacity; nothing if it is one in the scene. Throws Error.
    void draw(const Annotation& annotation, const FrameMoment& moment, Canvas& canvas);

    /// Where the annotation is on a picture of that size (pixels); none if it is one in the scene,
    /// or nothing is drawn. Throws Error.
    [[nodiscard]] std::optional<AnnotationBox> box_of(const Annotation& annotation,
                                                      const FrameMoment& moment,
                                                      const Vec2& picture);

    /// The part of its size at which it is drawn so that it fits on the picture, of one for which
    /// box_of has a box. Throws Error.
    [[nodiscard]] double scale_of(const Annotation& annotation, const FrameMoment& moment,
                                  const Vec2& picture);

  private:
    /// A text with the height of a line, and what is behind it by default.
    [[nodiscard]] FittedText drawn(const std::string& text, const Annotation& look,
                                   const FrameMoment& moment, double line_height,
                                   const TextBox& box, const Vec2& room);
    [[nodiscard]] FittedText drawn_text(const TextAnnotation& text, const Annotation& look,
                                        const FrameMoment& moment, const Vec2& picture);

    struct DrawnTitle {
        FittedText above;
        std::optional<FittedText> below;
        Vec2 size{0, 0};
        double scale = 1;
    };
    [[nodiscard]] DrawnTitle drawn_title(const TitleAnnotation& title, const Annotation& look,
                                         const FrameMoment& moment, const Vec2& picture);
    /// Both lines at a part of their size.
    [[nodiscard]] DrawnTitle title_at(double scale, const TitleAnnotation& title,
                                      const Annotation& look, const FrameMoment& moment,
                                      const Vec2& picture);
    [[nodiscard]] const SmallPlan& plan();

    void draw_title(const TitleAnnotation& title, const Annotation& look, const FrameMoment& moment,
                    const Vec2& corner, Canvas& canvas);

    /// Of one on the picture, pixels.
    [[nodiscard]] Vec2 size_of(const Annotation& look, const FrameMoment& moment,
                               const Vec2& picture);
    /// Of a diagram, plan or picture that has not been made smaller, pixels.
    [[nodiscard]] Vec2 full_size_of(const Annotation& look, double picture_height);
    [[nodiscard]] const Canvas& image_of(const std::string& file);
    [[nodiscard]] std::string filled(const std::string& text, const FrameMoment& moment) const;

    const Shot& shot_;
    const sim::Timeline& timeline_;
    Fonts& fonts_;
    std::unique_ptr<SmallPlan> plan_;                        // made for the first plan
    std::map<std::string, std::unique_ptr<Canvas>> images_;  // by file
};

}  // namespace carom::pipeline
