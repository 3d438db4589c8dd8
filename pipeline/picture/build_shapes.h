// Makes the shapes of annotations in the scene.
#pragma once

#include <cstddef>
#include <optional>

#include "pipeline/picture/annotation.h"
#include "pipeline/picture/pinhole.h"
#include "pipeline/picture/scene_shapes.h"
#include "pipeline/picture/values.h"
#include "pipeline/shot/shot.h"
#include "sim/timeline/timeline.h"

namespace carom::pipeline {

/// What a frame shows, for annotations in the scene. Refers to what it was made from.
struct SceneMoment {
    const Shot& shot;
    const sim::Timeline& timeline;
    const Pinhole& view;
    FrameMoment values;
    double time = 0;  // scene time in the middle of the exposure, s
    /// Among the paths of the shot, for a path: it decides about colour, dashes and number.
    std::size_t path_index = 0;
    std::size_t path_count = 1;

    /// Radius of a ball, or half a ball's usual size for other objects, m.
    [[nodiscard]] double radius(const std::string& object) const;
    /// Where a point is at that time, m.
    [[nodiscard]] Vec3 place(const ScenePoint& point) const;
};

/// The shapes of the annotation; none if it is one on the picture, or there is nothing to show at
/// that time. Throws Error.
[[nodiscard]] SceneShapes shapes_of(const Annotation& annotation, const SceneMoment& moment);

// The same of each kind.
[[nodiscard]] SceneShapes shapes_of(const PathAnnotation& path, const Annotation& look,
                                    const SceneMoment& moment);
[[nodiscard]] SceneShapes shapes_of(const AimAnnotation& aim, const Annotation& look,
                                    const SceneMoment& moment);
[[nodiscard]] SceneShapes shapes_of(const GhostAnnotation& ghost, const Annotation& look,
                                    const SceneMoment& moment);
[[nodiscard]] SceneShapes shapes_of(const TangentAnnotation& tangent, const Annotation& look,
                                    const SceneMoment& moment);
[[nodiscard]] SceneShapes shapes_of(const VelocityAnnotation& velocity, const Annotation& look,
                                    const SceneMoment& moment);
[[nodiscard]] SceneShapes shapes_of(const SpinAnnotation& spin, const Annotation& look,
                                    const SceneMoment& moment);
[[nodiscard]] SceneShapes shapes_of(const AngleAnnotation& angle, const Annotation& look,
                                    const SceneMoment& moment);
[[nodiscard]] SceneShapes shapes_of(const ZoneAnnotation& zone, const Annotation& look,
                                    const SceneMoment& moment);
[[nodiscard]] SceneShapes shapes_of(const LabelAnnotation& label, const Annotation& look,
                                    const SceneMoment& moment);

/// A text in the look of the annotation, at that place.
[[nodiscard]] SceneText scene_text(std::string text, const Vec3& at, const Annotation& look,
                                   double usual_size);

/// The edge of an area, in the look of the annotation. `usual_width`: picture heights.
[[nodiscard]] SceneLine edge_of(const SceneArea& area, const Annotation& look, double usual_width);

/// Points on a circle, from `start` (from the centre) on, turned by up to `turn` (rad) about the
/// unit `axis`.
[[nodiscard]] std::vector<Vec3> arc_points(const Vec3& centre, const Vec3& start, const Vec3& axis,
                                           double turn);

}  // namespace carom::pipeline
