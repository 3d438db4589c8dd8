#include "pipeline/job/viewed_frame.h"

#include "core/elementary.h"

namespace carom::pipeline {

ViewedFrame viewed_frame(std::span<const PlannedFrame> layers) {
    LensView mean;
    double weights = 0;
    for (const PlannedFrame& layer : layers) {
        const double fov = 0.5 * (layer.camera_open.vertical_fov + layer.camera_close.vertical_fov);
        mean.look.falloff += layer.weight * layer.look.falloff;
        mean.look.lateral_colour += layer.weight * layer.look.lateral_colour;
        mean.half_height += layer.weight * tangent(0.5 * fov);
        weights += layer.weight;
    }
    mean.look.falloff /= weights;
    mean.look.lateral_colour /= weights;
    mean.half_height /= weights;
    return {layers.front().number, mean};
}

}  // namespace carom::pipeline
