#include "render/integrator/distributed_integrator.h"

#include <cmath>
#include <deque>

#include "render/integrator/wave/hit_surfaces.h"
#include "render/sampling/gaussian_lobe.h"

namespace carom::render {
namespace {

NumberRows make_models(const std::vector<Material>& materials, SceneArena& arena) {
    NumberTable models;
    for (const Material& material : materials) {
        const PhongModel& phong = material.phong();
        scalar::ClassicOf<scalar::One> model{};
        model.emission = material.mean_emission();
        model.ambient = phong.ambient;
        model.has_ambient = phong.has_ambient ? 1.0F : 0.0F;
        model.diffuse_fraction = phong.diffuse_fraction;
        model.specular = phong.specular;
        model.shininess = phong.shininess;
        model.reflectance = phong.reflectance;
        model.metal = phong.metal;
        model.transmittance = phong.transmittance;
        model.index = phong.index;
        const auto within = [](float spread) {
            return spread > 0 ? gaussian_within_a_quarter_turn(spread) : 1.0F;
        };
        model.reflectance_spread = phong.reflectance_spread;
        model.reflectance_most = within(phong.reflectance_spread);
        model.transmittance_spread = phong.transmittance_spread;
        model.transmittance_most = within(phong.transmittance_spread);
        models.add(model);
    }
    return models.rows(arena);
}

}  // namespace

/// The rays of a generation that are followed together, and their vertices.
struct DistributedIntegrator::Generation {
    PathQueue rays;
    SurfaceQueue vertices;
    LobeWave reflection, refraction;
    QueueMemory memory;

    Generation() {
        memory.reserve(kWaveSamples, rays, vertices, reflection, refraction);
        refraction.side = -1;
    }
};

/// The rays of some camera samples. Of each generation one ray of a sample is followed at a time,
/// so that a sample's light is added up in the order of its tree.
struct DistributedIntegrator::Forest final : Integrator::Workspace {
    explicit Forest(const DistributedIntegrator& integrator)
        : surfaces(integrator.scene_, integrator.wave_scene_, *integrator.kernels_, kWaveSamples) {
        memory.reserve(kWaveSamples, own, samples, hit_rays);
        memory.reserve_shadows(kWaveSamples,
                               integrator.shadow_rays(integrator.settings_.shadow_samples), false,
                               shadows);
    }
    Generation& generation(int number) {
        while (generations.size() <= static_cast<std::size_t>(number)) {
            generations.emplace_back();
        }
        return generations[static_cast<std::size_t>(number)];
    }

    std::deque<Generation> generations;
    HitSurfaces surfaces;
    ShadowQueue shadows;
    Floats3 own;
    CameraSamples samples;
    IndexList hit_rays;
    QueueMemory memory;
    RadianceSample* results = nullptr;
    RenderStatistics* count = nullptr;
};

DistributedIntegrator::DistributedIntegrator(const TransportScene& scene,
                                             const DistributedSettings& settings)
    : scene_(scene),
      settings_(settings),
      wave_scene_(make_wave_scene(
          scene,
          [&](WaveScene& known, SceneArena& arena) {
              known.materials.classic = make_models(scene.materials, arena);
              known.materials.transmits = true;  // sides of surfaces matter
              known.absorbs = false;             // the model has no absorption
          },
          arena_)),
      kernels_(&best_wave_kernels()) {}

std::unique_ptr<Integrator::Workspace> DistributedIntegrator::make_workspace() const {
    return std::make_unique<Forest>(*this);
}

void DistributedIntegrator::samples(const CameraRun& run, float pixel_spread,
                                    RadianceSample* results, Workspace* workspace,
                                    RenderStatistics& count) const {
    Forest& forest = dynamic_cast<Forest&>(*workspace);
    forest.count = &count;
    for (int from = 0; from < run.count; from += kWaveSamples) {
        const CameraRun part = run.part(from, kWaveSamples);
        forest.results = results + from;
        std::fill_n(forest.results, part.count, RadianceSample{});
        begin_wave(part, pixel_spread, forest.samples, forest.generation(0).rays);
        count.camera_rays += static_cast<std::uint64_t>(part.count);
        trace(forest, 0);
    }
}

void DistributedIntegrator::trace(Forest& forest, int generation) const {
    Generation& all = forest.generation(generation);
    process_hits(forest, all, generation);
    const auto of_generation = [&](int samples) {
        return samples_at(samples, generation, settings_.falloff);
    };
    const DistributedStep step{
        wave_scene_,
        static_cast<float>(settings_.ambient_coefficient),
        {of_generation(settings_.shadow_samples), settings_.shadow_samples == 1,
         of_generation(settings_.reflection_samples), of_generation(settings_.refraction_samples)},
        forest.samples,
        all.rays,
        all.vertices,
        forest.shadows,
        forest.own,
        all.reflection,
        all.refraction};
    shade(forest, step);
    if (generation >= settings_.recursion_limit) {
        return;
    }
    kernels_->find_lobes(step, all.reflection, all.refraction);
    for (const LobeWave* lobe : {&all.refraction, &all.reflection}) {
        for (int k = 0; k < lobe->samples; ++k) {
            PathQueue& next = forest.generation(generation + 1).rays;
            next.count = 0;
            next.vertex = generation + 1;
            kernels_->send_rays(step, *lobe, k, next);
            const auto rays = static_cast<std::uint64_t>(next.count);
            forest.count->scattered_rays += rays;
            (lobe->side > 0 ? forest.count->reflection_rays : forest.count->refraction_rays) +=
                rays;
            if (rays > 0) {
                trace(forest, generation + 1);
            }
        }
    }
}

// Adds what rays see of lights and environment, and makes vertices of the other hits.
void DistributedIntegrator::process_hits(Forest& forest, Generation& all, int generation) const {
    PathQueue& rays = all.rays;
    const Hit* const hits = forest.surfaces.trace(rays);
    forest.hit_rays.count = 0;
    for (int i = 0; i < rays.count; ++i) {
        RadianceSample& result = forest.results[rays.slot.at[i]];
        const Hit& hit = hits[i];
        const V3f direction = rays.direction.get(i);
        if (hit.object == kNoObject) {
            result.radiance +=
                rays.throughput.get(i) * scene_.lights.environment().radiance(direction);
            continue;
        }
        if (generation == 0) {
            result.coverage = 1;
            result.object = hit.object;
            result.normal = -direction;
        }
        if (scene_.is_light(hit)) {
            result.radiance +=
                rays.throughput.get(i) *
                scene_.lights.emitted(scene_.light_of(hit), rays.origin.get(i) + direction * hit.t,
                                      -direction);
        } else {
            forest.hit_rays.add(i);
        }
    }
    forest.surfaces.find(rays, forest.hit_rays, all.vertices);
    for (int i = 0; generation == 0 && i < all.vertices.count; ++i) {
        RadianceSample& result = forest.results[rays.slot.at[all.vertices.path.at[i]]];
        result.normal = all.vertices.normal.get(i);
        result.albedo = all.vertices.base.get(i);
        result.roughness =
            std::sqrt(scene_.materials[static_cast<std::size_t>(all.vertices.material.at[i])]
                          .numbers()
                          .alpha);
    }
}

// Of a vertex, where each light gets so many. All rays to a delta light are the same.
int DistributedIntegrator::shadow_rays(int samples) const {
    int rays = 0;
    for (const WaveLight& light : wave_scene_.lights) {
        rays += light.kind == WaveLight::Kind::delta ? 1 : samples;
    }
    return rays;
}

void DistributedIntegrator::shade(Forest& forest, const DistributedStep& step) const {
    const int rays = shadow_rays(step.counts.shadow);
    ShadowQueue& shadows = forest.shadows;
    for (int first = 0; first < step.vertices.count; first = shadows.last) {
        begin_shadows(first, step.vertices.count, rays, shadows);
        kernels_->shade_rays(step, shadows);
        trace_shadows(scene_.frame.structure(), shadows);
        varying_emitters_.correct(shadows);
        const auto asked = static_cast<std::uint64_t>(rays) *
                           static_cast<std::uint64_t>(shadows.last - shadows.first);
        forest.count->shadow_rays += asked;
        forest.count->needless_shadow_rays += asked - static_cast<std::uint64_t>(shadows.count);
        kernels_->sum_light(shadows);
        for (int i = shadows.first; i < shadows.last; ++i) {
            RadianceSample& result = forest.results[step.rays.slot.at[step.vertices.path.at[i]]];
            result.radiance += forest.own.get(i) + shadows.sum.get(i);
        }
    }
}

}  // namespace carom::render
