#include "pipeline/picture/obstacles.h"

#include "render/acceleration/flush_denormals.h"

namespace carom::pipeline {
namespace {

/// Of the distance: surfaces in which an annotation lies do not hide it.
constexpr double kTolerance = 1e-5;

}  // namespace

Obstacles::Obstacles(const render::StaticGeometry& geometry, const sim::Timeline& timeline,
                     double scene_time)
    : scene_(geometry, timeline.tracks, scene_time, scene_time) {}

bool Obstacles::hides(const Vec3& eye, const Vec3& direction, double depth) const {
    const double length = direction.length();
    render::Ray ray;
    ray.origin = render::V3f(eye);
    ray.direction = render::V3f(direction / length);
    ray.t_max = static_cast<float>(depth * length * (1 - kTolerance));
    ray.kind = render::RayKind::primary;
    return ray.t_max > 0 && scene_.structure().any_hit(ray);
}

render::StaticGeometry obstacle_geometry(const render::SceneDescription& scene,
                                         render::RenderSettings settings) {
    const render::FlushDenormals flush;
    settings.acceleration = render::kOwnStructure;
    return render::StaticGeometry(scene, settings);
}

}  // namespace carom::pipeline
