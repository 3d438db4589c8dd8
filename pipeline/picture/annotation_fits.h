// How annotations fit on the pictures of a film.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "pipeline/camera/frame_range.h"
#include "pipeline/shot/shot.h"
#include "sim/timeline/timeline.h"

namespace carom::pipeline {

/// How one annotation fits on the picture.
struct AnnotationFit {
    double scale = 1;                          // of its size, the smallest at which it is drawn
    std::optional<FrameRange> smaller;         // frames in which it is below 1
    std::array<double, 4> beyond{0, 0, 0, 0};  // pixels beyond each edge, the most
    std::optional<FrameRange> outside;         // frames in which it is beyond one
};

/// The edges of AnnotationFit::beyond.
inline constexpr std::array kPictureEdges{"left", "right", "upper", "lower"};

/// Those of the shot's annotations, in up to 200 evenly spaced frames. Texts in the scene leave the
/// picture with what they belong to and are never beyond an edge. Throws Error if a font cannot be
/// read.
[[nodiscard]] std::vector<AnnotationFit> annotation_fits(const Shot& shot,
                                                         const sim::Timeline& timeline);

}  // namespace carom::pipeline
