// The annotations in the scene that are shown at a time.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "pipeline/picture/build_shapes.h"

namespace carom::pipeline {

struct ShownAnnotation {
    std::size_t index = 0;  // in the shot
    double opacity = 1;
    SceneShapes shapes;  // of one that is lit only texts, because the rest is an object
};

/// Those with an opacity above 0, in the order of the shot. `scene_time`: in the middle of the
/// exposure, s. Throws Error.
[[nodiscard]] std::vector<ShownAnnotation> shown_annotations(const Shot& shot,
                                                             const sim::Timeline& timeline,
                                                             const Pinhole& view,
                                                             const FrameMoment& values,
                                                             double scene_time);

/// The times of an annotation on its clock, s: scene times of one in the scene, video times of one
/// on the picture. There a moment is the video time at which the film has first shown it
/// (time_reached); infinite if it never does.
struct ShownTimes {
    std::optional<double> from{}, to{};
};
[[nodiscard]] ShownTimes shown_times(const Annotation& annotation, std::span<const CameraRig> rigs);

/// The opacity of an annotation with these times at a time of its clock (s), [0, 1]: 0 before
/// `from` and after `to`, and growing and falling linearly during `fade`.
[[nodiscard]] double opacity_at(const Annotation& annotation, const ShownTimes& times, double time);

}  // namespace carom::pipeline
