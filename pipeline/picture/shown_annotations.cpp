#include "pipeline/picture/shown_annotations.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <variant>

#include "pipeline/camera/shown_frame.h"

namespace carom::pipeline {
namespace {

bool is_path(const Annotation& annotation) {
    return std::holds_alternative<PathAnnotation>(annotation.kind);
}

SceneShapes drawn_shapes(const Annotation& annotation, const SceneMoment& moment) {
    SceneShapes shapes = shapes_of(annotation, moment);
    if (annotation.lit > 0) {
        std::erase_if(shapes, [](const SceneShape& shape) {
            return !std::holds_alternative<SceneText>(shape);
        });
    }
    return shapes;
}

}  // namespace

std::vector<ShownAnnotation> shown_annotations(const Shot& shot, const sim::Timeline& timeline,
                                               const Pinhole& view, const FrameMoment& values,
                                               double scene_time) {
    const auto paths = static_cast<std::size_t>(std::ranges::count_if(shot.annotations, is_path));
    SceneMoment moment{shot, timeline, view, values, scene_time, 0, paths};
    std::vector<ShownAnnotation> shown;
    for (std::size_t i = 0; i < shot.annotations.size(); ++i) {
        const Annotation& annotation = shot.annotations[i];
        const double opacity = is_in_scene(annotation)
                                   ? opacity_at(annotation, shown_times(annotation, {}), scene_time)
                                   : 0;
        if (opacity > 0) {
            shown.push_back({i, opacity, drawn_shapes(annotation, moment)});
        }
        moment.path_index += is_path(annotation) ? 1 : 0;
    }
    return shown;
}

ShownTimes shown_times(const Annotation& annotation, std::span<const CameraRig> rigs) {
    constexpr double kJustBefore = 1e-9;  // s: a text that takes over at the same moment is alone
    const bool is_on_picture = !is_in_scene(annotation);
    const auto time_of = [&](const AnnotationTime& time, double sooner) {
        return time.is_moment && is_on_picture
                   ? time_reached(time.seconds, rigs)
                             .value_or(std::numeric_limits<double>::infinity()) -
                         sooner
                   : time.seconds;
    };
    ShownTimes times;
    if (annotation.from) {
        times.from = time_of(*annotation.from, 0);
    }
    if (annotation.to) {
        times.to = time_of(*annotation.to, kJustBefore);
    }
    return times;
}

double opacity_at(const Annotation& annotation, const ShownTimes& times, double time) {
    const double shown = times.from ? time - *times.from : 0;
    const double left = times.to ? *times.to - time : 0;
    if (shown < 0 || left < 0) {
        return 0;
    }
    double opacity = annotation.opacity;
    if (annotation.fade > 0 && annotation.from) {
        opacity *= std::min(1.0, shown / annotation.fade);
    }
    if (annotation.fade > 0 && annotation.to) {
        opacity *= std::min(1.0, left / annotation.fade);
    }
    return opacity;
}

}  // namespace carom::pipeline
