// The state of many paths as structures of arrays, for vector code. Plain data.
#pragma once

#include <cstdint>

#include "render/acceleration/ray_batch.h"
#include "render/integrator/path_state.h"

namespace carom::render {

/// Largest number of camera samples in a wave, and of paths: a sample may split twice.
inline constexpr int kWaveSamples = 512;
inline constexpr int kWavePaths = 10 * kWaveSamples;
/// Vector code may read and write beyond the last path.
inline constexpr int kWaveStorage = kWavePaths + 16;

struct Floats {
    alignas(64) float at[kWaveStorage];
};
struct Words {
    alignas(64) std::int32_t at[kWaveStorage];
};
struct Floats3 {
    Floats x, y, z;

    [[nodiscard]] V3f get(int i) const { return {x.at[i], y.at[i], z.at[i]}; }
    void set(int i, const V3f& v) {
        x.at[i] = v.x;
        y.at[i] = v.y;
        z.at[i] = v.z;
    }
};

/// Path and LastScattering (path_state.h) of many paths; all paths lead to a vertex of the same
/// index.
struct PathWave {
    int count = 0;
    int vertex = 0;
    Words slot;  // the camera sample that the path belongs to
    Words branch;
    Floats3 origin, direction;
    Floats time;
    Floats3 throughput;
    Floats width, spread;
    Floats3 last_position, last_normal;
    Floats pdf;
    Floats total_importance, environment_samples;
    Words is_delta, connects;  // 1 or 0
    Words connected_ball;

    [[nodiscard]] Ray ray(int i) const {
        return {origin.get(i), direction.get(i), 0, kInfinity, time.at[i], kind()};
    }
    [[nodiscard]] RayKind kind() const {
        return vertex == 0 ? RayKind::primary : RayKind::secondary;
    }
    [[nodiscard]] RayBatch rays() const {
        return {count,
                {origin.x.at, origin.y.at, origin.z.at},
                {direction.x.at, direction.y.at, direction.z.at},
                time.at,
                kind()};
    }
    /// One path alone, for scalar code.
    [[nodiscard]] Path path(int i) const {
        Path path{ray(i)};
        path.throughput = throughput.get(i);
        path.last.position = last_position.get(i);
        path.last.normal = last_normal.get(i);
        path.last.pdf = pdf.at[i];
        path.last.is_delta = is_delta.at[i] != 0;
        path.last.connects = connects.at[i] != 0;
        path.last.connected_ball = connected_ball.at[i];
        path.last.all_lights = vertex == 1;
        path.last.total_importance = total_importance.at[i];
        path.last.environment_samples = environment_samples.at[i];
        path.vertex = vertex;
        path.branch = static_cast<std::uint32_t>(branch.at[i]);
        path.width = width.at[i];
        path.spread = spread.at[i];
        return path;
    }
};

/// The vertices of a wave.
struct VertexWave {
    int count = 0;
    bool has_gloss = false;  // some of them have a rough coat that is sampled several times
    Words path;              // index in the PathWave
    Words object;
    Words material;
    Floats distance;  // along the path's ray, m
    Floats3 position;
    Floats3 geometric_normal, normal;  // on the viewer's side
    Floats offset;                     // m
    Floats3 base;
};

/// Shadow rays of a wave's vertices, at most `rays` for each vertex. The first rays of all vertices
/// are stored before the second ones.
struct ShadowWave {
    static constexpr int kMostRays = 32;  // of a first vertex
    static constexpr int kStorage = kMostRays * (kWaveSamples + 16);
    static_assert(kStorage >= kWaveStorage);

    int stride = 0;  // from a vertex's ray to its next one
    int rays = 0;    // of each vertex
    int count = 0;   // of rays that were asked for
    Floats3 origin;  // by vertex
    Floats time;     // by vertex
    Floats3 sum;     // by vertex: all light that arrives
    alignas(64) float x[kStorage];
    alignas(64) float y[kStorage];
    alignas(64) float z[kStorage];
    alignas(64) float t_max[kStorage];  // m; 0: no ray
    alignas(64) float red[kStorage];    // of the light that arrives unless occluded
    alignas(64) float green[kStorage];
    alignas(64) float blue[kStorage];

    /// The `k`th rays of `vertices` vertices.
    [[nodiscard]] RayBatch batch(int k, int vertices) const {
        const int first = k * stride;
        return {vertices,
                {origin.x.at, origin.y.at, origin.z.at},
                {x + first, y + first, z + first},
                time.at,
                RayKind::shadow};
    }
};

/// What belongs to the camera samples of a wave.
struct SampleWave {
    Words pixel_hash, reversed_sample;  // of their random numbers
};

/// Indices of vertices or paths.
struct WaveList {
    int count = 0;
    Words at;

    void add(int index) { at.at[count++] = index; }
};

/// Paths that left the scene, and the radiance that they bring.
struct MissWave {
    WaveList paths;
    Floats3 light;  // by the place in the list
};

}  // namespace carom::render
