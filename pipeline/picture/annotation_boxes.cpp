#include "pipeline/picture/annotation_boxes.h"

#include "core/error.h"
#include "pipeline/picture/picture_items.h"

namespace carom::pipeline {

std::vector<std::optional<AnnotationBox>> annotation_boxes(const Shot& shot,
                                                           const sim::Timeline& timeline) {
    Fonts fonts;
    PictureItems items(shot, timeline, fonts);
    const Vec2 picture(shot.render.width, shot.render.height);
    std::vector<std::optional<AnnotationBox>> boxes;
    for (const Annotation& annotation : shot.annotations) {
        try {
            boxes.push_back(items.box_of(annotation, {}, picture));
        } catch (const Error&) {
            boxes.emplace_back();
        }
    }
    return boxes;
}

}  // namespace carom::pipeline
