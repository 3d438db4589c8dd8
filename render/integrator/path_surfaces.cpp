// What a path integrator does with the surfaces that paths reach, besides scattering.
#include <algorithm>
#include <cmath>

#include "render/integrator/path_wave.h"
#include "render/integrator/wave/scalar_kernels.h"

namespace carom::render {
void PathIntegrator::note_first_surfaces(const SurfaceQueue& vertices, Wave& wave) const {
    for (int i = 0; i < vertices.count; ++i) {
        RadianceSample& result = wave.sample_of(vertices.path.at[i]).result;
        result.coverage = 1;
        result.object = static_cast<std::uint32_t>(vertices.object.at[i]);
        result.normal = vertices.normal.get(i);
        result.albedo = vertices.base.get(i);
        result.roughness = vertices.numbers != nullptr
                               ? std::sqrt(wave.numbers[kRoughness].at[i])
                               : roughness_[static_cast<std::size_t>(vertices.material.at[i])];
    }
}

// In the order of the paths, so that that of the groups does not matter.
void PathIntegrator::note_mirrored_surfaces(Wave& wave) {
    const PathQueue& paths = wave.paths();
    for (Floats* channel : {&wave.mirrored.x, &wave.mirrored.y, &wave.mirrored.z}) {
        std::fill_n(channel->at, paths.count, 0.0F);
    }
    for (const SurfaceQueue* vertices : {&wave.vertices, &wave.far_ends}) {
        for (int i = 0; i < vertices->count; ++i) {
            const int path = vertices->path.at[i];
            wave.mirrored.set(path, paths.throughput.get(path) * vertices->base.get(i));
        }
    }
    for (int path = 0; path < paths.count; ++path) {
        if (is_seen_in_coat(1, static_cast<std::uint32_t>(paths.branch.at[path]))) {
            wave.sample_of(path).result.mirrored += wave.mirrored.get(path);
        }
    }
}

bool PathIntegrator::is_far(int path, const Hit& hit, Wave& wave) const {
    const PathQueue& paths = wave.paths();
    return far_surfaces_.exist() &&
           far_surfaces_.is_far(paths.origin.get(path), paths.direction.get(path), hit,
                                wave.sample_of(path).far_part);
}

void PathIntegrator::add_far_ends(Wave& wave) const {
    wave.far_ends.count = 0;
    if (wave.far_paths.count == 0) {
        return;
    }
    const PathQueue& paths = wave.paths();
    const SurfaceQueue& ends = wave.far_ends;
    wave.surfaces.find(paths, wave.far_paths, wave.far_ends);
    if (wave.vertex == 0) {
        note_first_surfaces(ends, wave);
    }
    for (int i = 0; i < ends.count; ++i) {
        const int path = ends.path.at[i];
        const V3f light = far_surfaces_.seen(wave_scene_, ends, i, -paths.direction.get(path));
        wave.add(path, paths.throughput.get(path) * light, wave.vertex);
    }
}

// Those with a smooth coat: the vertex adds what is diffuse, and only its gloss continues.
void PathIntegrator::add_far_vertices(Wave& wave) const {
    if (!far_surfaces_.exist() || wave.vertex > 0) {
        return;
    }
    const PathQueue& paths = wave.paths();
    const SurfaceQueue& vertices = wave.vertices;
    for (int i = 0; i < vertices.count; ++i) {
        const int path = vertices.path.at[i];
        const Hit hit{vertices.distance.at[i], static_cast<std::uint32_t>(vertices.object.at[i])};
        if (!is_far(path, hit, wave)) {
            continue;
        }
        const V3f diffuse =
            far_surfaces_.diffuse(wave_scene_, vertices, i, -paths.direction.get(path));
        wave.add(path, paths.throughput.get(path) * diffuse, wave.vertex);
        vertices.base.set(i, V3f(0));
    }
}

// See PathSettings::white.
void PathIntegrator::whiten(Wave& wave) const {
    if (settings_.white < 0) {
        return;
    }
    const SurfaceQueue& vertices = wave.vertices;
    for (int i = 0; i < vertices.count; ++i) {
        vertices.material.at[i] = settings_.white;
        vertices.base.set(i, V3f(1));
        vertices.normal.set(i, vertices.geometric_normal.get(i));
        for (int number = 0; vertices.numbers != nullptr && number < kTexturedNumbers; ++number) {
            vertices.numbers[number].at[i] =
                number == kRoughness || number == kCoatRoughness ? 1 : 0;
        }
    }
}

}  // namespace carom::render
