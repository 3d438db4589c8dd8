// The state of a wave of paths. Internal to this folder.
#pragma once

#include <array>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <vector>

#include "render/geometry/validity.h"
#include "render/integrator/branch_sums.h"
#include "render/integrator/path_integrator.h"
#include "render/integrator/wave/hit_surfaces.h"

namespace carom::render {

/// A camera sample of a wave.
struct PathIntegrator::Sample {
    PathDimensions dimensions;
    SampleIndex index;
    float far_part = 0;  // FarSurfaces::is_far
    RadianceSample result{};
};

struct PathIntegrator::Wave final : Integrator::Workspace {
    PathQueue of_even_vertices, of_odd_vertices;
    PathQueue& paths() { return vertex % 2 == 0 ? of_even_vertices : of_odd_vertices; }
    PathQueue& next() { return vertex % 2 == 0 ? of_odd_vertices : of_even_vertices; }
    PathQueue scattered;  // to be appended to `next`
    int vertex = 0;
    SurfaceQueue vertices;
    std::array<Floats, kTexturedNumbers> numbers;
    ShadowQueue shadows;
    CameraSamples samples;
    IndexList near_spheres;
    EscapedQueue missed;
    HitSurfaces surfaces;
    IndexList hit_paths;  // that become vertices
    // Paths that end on far surfaces, and where.
    IndexList far_paths;
    SurfaceQueue far_ends;
    std::optional<FarShadows> far_shadows;
    std::vector<Sample> from_camera;
    BranchSums sums;
    Floats3 mirrored;  // by path
    QueueMemory memory;

    explicit Wave(const PathIntegrator& integrator)
        : surfaces(integrator.scene_, integrator.wave_scene_, *integrator.kernels_,
                   integrator.most_paths_),
          sums(integrator.wave_samples_, integrator.wave_scene_.glossy_samples) {
        const WaveScene& scene = integrator.wave_scene_;
        if (integrator.far_surfaces_.exist()) {
            memory.reserve(integrator.most_paths_, far_paths, far_ends);
            far_shadows.emplace(integrator.scene_);
        }
        memory.reserve(integrator.most_paths_, of_even_vertices, of_odd_vertices, scattered,
                       vertices, near_spheres, missed, hit_paths, mirrored);
        memory.reserve(integrator.wave_samples_, samples);
        if (scene.materials.varies) {
            for (Floats& number : numbers) {
                memory.reserve(integrator.most_paths_, number);
            }
            vertices.numbers = numbers.data();
            far_ends.numbers = numbers.data();
        }
        memory.reserve_shadows(integrator.most_paths_, scene.first_rays() + scene.further_rays(),
                               scene.materials.transmits, shadows);
    }

    [[nodiscard]] Sample& sample_of(int path) {
        return from_camera[static_cast<std::size_t>(paths().slot.at[path])];
    }
    /// Adds light that a path found.
    void add(int path, const V3f& radiance, int scatterings) {
        validate(path, radiance);
        sums.add(paths().slot.at[path], vertex, static_cast<std::uint32_t>(paths().branch.at[path]),
                 radiance, scatterings);
    }
    /// Adds the light of a lamp or the room that a path reached, reduced by its throughput.
    void add_light(int path, const V3f& radiance) {
        add(path, radiance, vertex);
        if (is_imaged(vertex, static_cast<std::uint32_t>(paths().branch.at[path]),
                      paths().is_delta.at[path] != 0)) {
            sample_of(path).result.light += radiance;
        }
    }

  private:
    // With expensive checks on, an invalid radiance stops the program where it first appears.
    void validate([[maybe_unused]] int path, [[maybe_unused]] const V3f& radiance) {
#ifdef CAROM_VALIDATION
        if (!is_light(radiance)) {
            const SampleIndex& index = sample_of(path).index;
            std::fprintf(stderr, "radiance (%g, %g, %g) in sample %d of pixel (%d, %d)\n",
                         static_cast<double>(radiance.x), static_cast<double>(radiance.y),
                         static_cast<double>(radiance.z), index.sample, index.x, index.y);
            std::abort();
        }
#endif
    }
};

}  // namespace carom::render
