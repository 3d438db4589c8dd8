// Parts of measurements in which structures answer given rays.
#pragma once

#include <algorithm>
#include <stop_token>

#include "core/cpu_time.h"
#include "core/error.h"
#include "lab/comparison/laboratory_scene.h"
#include "lab/structures/structure_meter.h"
#include "render/frame_scene/frame_scene.h"
#include "render/frame_scene/static_geometry.h"
#include "render/geometry/ray.h"

namespace carom::pipeline {

/// Throws Stopped.
inline void check_stop(const std::stop_token& stop) {
    if (stop.stop_requested()) {
        throw Stopped();
    }
}

/// Frames of a scene whose structures are of one kind.
class MeasuredScene {
  public:
    /// Refers to the scene.
    MeasuredScene(const LaboratoryScene& scene, render::AccelerationKind kind)
        : scene_(scene),
          structure_(kind),
          geometry_(scene.scene, scene.settings, structure_.maker()) {}

    [[nodiscard]] render::StructureMeter& structure() { return structure_; }
    /// From `open` to `close`, s.
    [[nodiscard]] render::FrameScene frame(double open, double close) const {
        return {geometry_, scene_.tracks, open, close};
    }
    /// At the scene's own time.
    [[nodiscard]] render::FrameScene frame() const {
        return frame(scene_.frame.scene_open, scene_.frame.scene_close);
    }

  private:
    const LaboratoryScene& scene_;
    render::StructureMeter structure_;
    render::StaticGeometry geometry_;
};

/// Whether the ray hits something: a shadow ray ends at any hit.
[[nodiscard]] inline bool hits(const render::AccelerationStructure& structure,
                               const render::Ray& ray) {
    render::Hit hit;
    return ray.kind == render::RayKind::shadow ? structure.any_hit(ray)
                                               : structure.closest_hit(ray, hit);
}

/// CPU time of `work`, the least of several runs, because other load on the machine only slows it
/// down. `enough`: s.
template <class Work>
double least_seconds(const Work& work, double enough, const std::stop_token& stop) {
    constexpr int kMost = 12;
    double least = 1e300;
    double all = 0;
    for (int i = 0; i < kMost && (i < 2 || all < enough); ++i) {
        check_stop(stop);
        const double start = process_cpu_seconds();
        work();
        const double seconds = process_cpu_seconds() - start;
        all += seconds;
        least = std::min(least, seconds);
    }
    return least;
}

}  // namespace carom::pipeline
