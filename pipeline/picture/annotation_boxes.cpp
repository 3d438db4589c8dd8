#include "pipeline/picture/annotation_boxes.h"

#include <cmath>
#include <cstdint>

#include "core/error.h"
#include "pipeline/camera/frame_plan.h"
#include "pipeline/picture/picture_items.h"
#include "pipeline/picture/shown_annotations.h"

namespace carom::pipeline {

namespace {

/// That of the first frame with the annotation. Without values if the cameras do not have that
/// frame.
FrameMoment first_moment(const Annotation& annotation, const Shot& shot,
                         const sim::Timeline& timeline) {
    const std::int64_t count = frame_count(shot.cameras, shot.timing);
    const double from = shown_times(annotation, shot.cameras).from.value_or(0);
    const double number = std::ceil(from * shot.timing.fps.to_double() - 1e-6);
    try {
        return count > 0 && number < static_cast<double>(count)
                   ? moment_of(plan_frame(static_cast<std::int64_t>(number), shot.cameras,
                                          shot.timing, timeline))
                   : FrameMoment{};
    } catch (const Error&) {  // an object that the motion does not have yet
        return {};
    }
}

}  // namespace

std::vector<std::optional<AnnotationBox>> annotation_boxes(const Shot& shot,
                                                           const sim::Timeline& timeline) {
    Fonts fonts;
    PictureItems items(shot, timeline, fonts);
    const Vec2 picture(shot.render.width, shot.render.height);
    std::vector<std::optional<AnnotationBox>> boxes;
    for (const Annotation& annotation : shot.annotations) {
        try {
            boxes.push_back(
                is_in_scene(annotation)
                    ? std::nullopt
                    : items.box_of(annotation, first_moment(annotation, shot, timeline), picture));
        } catch (const Error&) {
            boxes.emplace_back();
        }
    }
    return boxes;
}

}  // namespace carom::pipeline
