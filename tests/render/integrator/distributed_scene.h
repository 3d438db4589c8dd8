// A scene, one ray, and the distributed integrator's result.
#pragma once

#include "render/frame/prepared_scene.h"
#include "render/integrator/distributed_integrator.h"
#include "tests/render/scene_builder.h"

namespace carom::test {

/// Neither diffuse nor ambient: reflection and refraction only.
inline render::PhongMaterial phong_black() {
    render::PhongMaterial material;
    material.diffuse = Vec3(0, 0, 0);
    return material;
}

inline Vec3 grey(double value) {
    return Vec3(value, value, value);
}

/// All counts at 1: Whitted's tracer. No ambient light.
inline render::DistributedSettings whitted(int recursion_limit) {
    render::DistributedSettings settings;
    settings.pixel_samples = settings.blur_samples = settings.lens_samples = 1;
    settings.shadow_samples = settings.reflection_samples = settings.refraction_samples = 1;
    settings.recursion_limit = recursion_limit;
    settings.ambient_coefficient = 0;
    return settings;
}

struct Traced {
    render::RadianceSample sample;
    render::RenderStatistics count;
};

class DistributedScene {
  public:
    explicit DistributedScene(const render::SceneDescription& scene)
        : prepared_(scene, small_settings(1, 1, 1)), frame_(prepared_.data().geometry, {}, 0, 0) {}

    [[nodiscard]] Traced trace(const render::DistributedSettings& settings, const Vec3& origin,
                               const Vec3& direction, std::uint32_t sample = 0) const {
        const auto& data = prepared_.data();
        const render::DistributedIntegrator integrator(
            {frame_, data.materials, data.lights, data.object_count}, settings);
        render::CameraBatch batch;
        batch.add(render::SampleStream(1, 0, 0, sample), {});
        const Vec3 towards = direction.normalized();
        for (int axis = 0; axis < 3; ++axis) {
            batch.origin[axis][0] = static_cast<float>(origin[axis]);
            batch.direction[axis][0] = static_cast<float>(towards[axis]);
        }
        Traced result;
        integrator.samples(render::CameraRun::all(batch), 0.001f, &result.sample,
                           integrator.make_workspace().get(), result.count);
        return result;
    }

    /// Mean red value of `samples` camera samples along the same ray.
    [[nodiscard]] double mean(const render::DistributedSettings& settings, const Vec3& origin,
                              const Vec3& direction, int samples) const {
        double sum = 0;
        for (int i = 0; i < samples; ++i) {
            const auto index = static_cast<std::uint32_t>(i);
            sum += trace(settings, origin, direction, index).sample.radiance.x;
        }
        return sum / samples;
    }

  private:
    render::PreparedScene prepared_;
    render::FrameScene frame_;
};

}  // namespace carom::test
