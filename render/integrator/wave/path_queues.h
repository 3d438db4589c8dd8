// The state of many paths as structures of arrays, for kernels. Plain data: their memory is that of
// queue_memory.h.
#pragma once

#include <cstdint>

#include "render/geometry/ray.h"

namespace carom::render {

// Vector code may read and write beyond the last number of an array.
struct Floats {
    float* at = nullptr;
};
struct Words {
    std::int32_t* at = nullptr;
};
struct Floats3 {
    Floats x, y, z;

    [[nodiscard]] V3f get(int i) const { return {x.at[i], y.at[i], z.at[i]}; }
    void set(int i, const V3f& v) const {
        x.at[i] = v.x;
        y.at[i] = v.y;
        z.at[i] = v.z;
    }
};

/// Path and LastScattering (path_state.h) of many paths; all paths lead to a vertex of the same
/// index.
struct PathQueue {
    int count = 0;
    int vertex = 0;
    Words slot;  // the camera sample that the path belongs to
    Words branch;
    Floats3 origin, direction;
    Floats time;
    Floats3 throughput;
    Floats cone_width, cone_spread;
    Floats3 last_position, last_normal;
    Floats pdf;
    Floats total_importance, environment_samples;
    Words is_delta, connects;  // 1 or 0
    /// LastScattering::connected_sphere, with this bit if the path passed the sphere.
    static constexpr std::int32_t kPassedSphere = 1 << 30;
    Words connected_sphere;
    Words entered_sphere;  // set in scenes with surfaces that transmit

    /// Calls `visit` with every array.
    template <class Visit>
    void each_array(const Visit& visit) {
        visit(slot, branch, origin, direction, time, throughput, cone_width, cone_spread,
              last_position, last_normal, pdf, total_importance, environment_samples, is_delta,
              connects, connected_sphere, entered_sphere);
    }
};

/// The vertices of a wave.
struct SurfaceQueue {
    int count = 0;
    bool has_gloss = false;  // some of them have a rough coat that is sampled several times
    bool some_end = false;   // `ends` is set
    Words path;              // index in the PathQueue
    Words object;
    Words material;
    Floats distance;  // along the path's ray, m
    Floats3 position;
    Floats3 geometric_normal, normal;  // on the viewer's side
    Floats offset;                     // m
    Floats3 base;
    /// The TexturedNumbers, by their order, in scenes where those of materials vary: an array each.
    const Floats* numbers = nullptr;
    Words from_behind;  // 1 or 0; in scenes with surfaces that transmit
    Words ends;         // 1: the path ends here

    template <class Visit>
    void each_array(const Visit& visit) {
        visit(path, object, material, distance, position, geometric_normal, normal, offset, base,
              from_behind, ends);
    }
};

/// Shadow rays of the vertices [first, last) of a wave, `rays` for each vertex. The first rays of
/// all vertices are stored before the second ones.
struct ShadowQueue {
    int first = 0, last = 0;
    int stride = 0;  // from a vertex's ray to its next one
    int rays = 0;    // of each vertex
    int count = 0;   // of rays that were asked for
    // By vertex.
    Floats3 origin;
    Floats time;
    Floats3 sum;  // all light that arrives
    // By ray.
    Floats3 direction;
    Floats t_max;        // m; 0: no ray
    Floats3 radiance;    // that arrives unless occluded
    Floats3 ray_origin;  // in scenes with surfaces that transmit; else null

    /// Where the `k`th ray of a vertex is.
    [[nodiscard]] int place(int k, int vertex) const { return k * stride + (vertex - first); }
};

/// What belongs to the camera samples of a wave.
struct CameraSamples {
    Words pixel_hash, reversed_sample;  // of their random numbers

    template <class Visit>
    void each_array(const Visit& visit) {
        visit(pixel_hash, reversed_sample);
    }
};

/// Indices of vertices or paths.
struct IndexList {
    int count = 0;
    Words at;

    void add(int index) { at.at[count++] = index; }

    template <class Visit>
    void each_array(const Visit& visit) {
        visit(at);
    }
};

/// Paths that left the scene, and the radiance that they bring.
struct EscapedQueue {
    IndexList paths;
    Floats3 light;  // by the place in the list

    template <class Visit>
    void each_array(const Visit& visit) {
        visit(paths.at, light);
    }
};

/// Rays of one kind that the vertices of a wave of distributed ray tracing send, each around one
/// direction.
struct LobeWave {
    float side = 1;   // of the surface that they leave from: 1 the viewer's, -1 the other
    int samples = 0;  // the most of any vertex
    Floats3 axis;     // unit
    Floats3 colour;   // factor on the light of a ray, besides its weight, the cosine to the axis
    Floats spread;    // standard deviation of the angle, rad; 0: all rays are along the axis
    Floats most;      // gaussian_within_a_quarter_turn of it
    Words count;      // of rays

    template <class Visit>
    void each_array(const Visit& visit) {
        visit(axis, colour, spread, most, count);
    }
};

}  // namespace carom::render
