// Where annotations are on the picture, for programs that show or move them.
#pragma once

#include <optional>
#include <vector>

#include "core/vectors.h"
#include "pipeline/shot/shot.h"
#include "sim/timeline/timeline.h"

namespace carom::pipeline {

/// The rectangle of the picture that an annotation fills, pixels.
struct AnnotationBox {
    Vec2 corner{0, 0};  // the upper left one
    Vec2 size{0, 0};
};

/// The boxes of all annotations of the shot on a film of its size, with the values that their texts
/// have when they appear; none for those in the scene, those that draw nothing, and those whose
/// picture cannot be read.
[[nodiscard]] std::vector<std::optional<AnnotationBox>> annotation_boxes(
    const Shot& shot, const sim::Timeline& timeline);

}  // namespace carom::pipeline
