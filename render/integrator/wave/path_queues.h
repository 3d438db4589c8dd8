// The state of many paths as structures of arrays, for vector code. Plain data.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

#include "render/acceleration/acceleration_structure.h"
#include "render/acceleration/large_vector.h"
#include "render/integrator/path_state.h"

namespace carom::render {

/// Largest number of camera samples in a wave, and of paths: a sample may split twice.
inline constexpr int kWaveSamples = 512;
inline constexpr int kQueuePaths = 10 * kWaveSamples;

/// Numbers for vector code, which may read and write beyond the last one. All are 0 at first, so
/// that what lies there is harmless.
template <class T>
struct WaveArray {
    static constexpr int kBeyond = 16;

    T* at = nullptr;

    WaveArray() = default;
    WaveArray(const WaveArray&) = delete;
    WaveArray& operator=(const WaveArray&) = delete;
    WaveArray(WaveArray&&) noexcept = default;
    WaveArray& operator=(WaveArray&&) noexcept = default;
    ~WaveArray() = default;

    void reserve(int count) {
        numbers_.assign(static_cast<std::size_t>(count) + kBeyond, T());
        at = numbers_.data();
    }

  private:
    LargeVector<T> numbers_;
};
using Floats = WaveArray<float>;
using Words = WaveArray<std::int32_t>;
struct Floats3 {
    Floats x, y, z;

    void reserve(int count) {
        for (Floats* channel : {&x, &y, &z}) {
            channel->reserve(count);
        }
    }
    [[nodiscard]] V3f get(int i) const { return {x.at[i], y.at[i], z.at[i]}; }
    void set(int i, const V3f& v) {
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

    /// Pointers to all arrays.
    static constexpr auto fields() {
        return std::tuple(&PathQueue::slot, &PathQueue::branch, &PathQueue::origin,
                          &PathQueue::direction, &PathQueue::time, &PathQueue::throughput,
                          &PathQueue::cone_width, &PathQueue::cone_spread,
                          &PathQueue::last_position, &PathQueue::last_normal, &PathQueue::pdf,
                          &PathQueue::total_importance, &PathQueue::environment_samples,
                          &PathQueue::is_delta, &PathQueue::connects, &PathQueue::connected_sphere,
                          &PathQueue::entered_sphere);
    }
    void reserve(int paths) {
        std::apply([&](auto... field) { ((this->*field).reserve(paths), ...); }, fields());
    }
    /// Appends other paths.
    void append(const PathQueue& more) {
        std::apply([&](auto... field) { (copy(more.*field, more.count, this->*field), ...); },
                   fields());
        count += more.count;
    }

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
        const std::int32_t sphere = connected_sphere.at[i];
        path.last.connected_sphere = sphere < 0 ? -1 : sphere & ~kPassedSphere;
        path.last.passed_sphere = sphere >= 0 && (sphere & kPassedSphere) != 0;
        path.last.all_lights = vertex == 1;
        path.last.total_importance = total_importance.at[i];
        path.vertex = vertex;
        path.branch = static_cast<std::uint32_t>(branch.at[i]);
        return path;
    }

  private:
    template <class T>
    void copy(const WaveArray<T>& more, int number, WaveArray<T>& to) const {
        std::copy_n(more.at, number, to.at + count);
    }
    void copy(const Floats3& more, int number, Floats3& to) const {
        copy(more.x, number, to.x);
        copy(more.y, number, to.y);
        copy(more.z, number, to.z);
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
    Words from_behind;  // 1 or 0; in scenes with surfaces that transmit
    Words ends;         // 1: the path ends here

    void reserve(int vertices) {
        for (Words* words : {&path, &object, &material, &from_behind, &ends}) {
            words->reserve(vertices);
        }
        for (Floats3* floats : {&position, &geometric_normal, &normal, &base}) {
            floats->reserve(vertices);
        }
        distance.reserve(vertices);
        offset.reserve(vertices);
    }
};

/// Shadow rays of the vertices [first, last) of a wave, `rays` for each vertex. The first rays of
/// all vertices are stored before the second ones.
struct ShadowQueue {
    /// About as many rays are traced together, but always those of one vector of vertices.
    static constexpr int kRays = 32 * kWaveSamples;
    static constexpr int kLanes = 16;

    int first = 0, last = 0;
    int stride = 0;  // from a vertex's ray to its next one
    int rays = 0;    // of each vertex
    int count = 0;   // of rays that were asked for
    Floats3 origin;  // by vertex
    Floats time;     // by vertex
    Floats3 sum;     // by vertex: all light that arrives
    std::vector<float> x, y, z;
    std::vector<float> t_max;             // m; 0: no ray
    std::vector<float> red, green, blue;  // of the light that arrives unless occluded
    // Of each ray, in scenes with surfaces that transmit.
    std::vector<float> origin_x, origin_y, origin_z;

    void reserve(int vertices) {
        origin.reserve(vertices);
        time.reserve(vertices);
        sum.reserve(vertices);
    }
    /// Of the vertices from `from` on takes as many as fit, to whom so many `rays` will be added.
    void begin(int from, int vertices, int rays_of_each, bool has_origins) {
        first = from;
        rays = rays_of_each;
        count = 0;
        const int most = rays > 0 ? kRays / rays / kLanes * kLanes : vertices;
        last = std::min(vertices, from + std::max(most, kLanes));
        stride = last - first + kLanes;
        const std::size_t size = static_cast<std::size_t>(stride) * static_cast<std::size_t>(rays);
        for (auto* numbers : {&x, &y, &z, &t_max, &red, &green, &blue}) {
            numbers->resize(std::max(numbers->size(), size));
        }
        for (auto* numbers : {&origin_x, &origin_y, &origin_z}) {
            numbers->resize(has_origins ? std::max(numbers->size(), size) : 0);
        }
    }
    /// Where the `k`th ray of a vertex is.
    [[nodiscard]] std::size_t place(int k, int vertex) const {
        return static_cast<std::size_t>(k) * static_cast<std::size_t>(stride) +
               static_cast<std::size_t>(vertex - first);
    }
    /// Sets `t_max` to 0 for rays that are occluded.
    void trace(const AccelerationStructure& structure) {
        for (int k = 0; k < rays; ++k) {
            structure.test_occlusion(batch(k), t_max.data() + place(k, first));
        }
    }

  private:
    /// The `k`th rays of all vertices.
    [[nodiscard]] RayBatch batch(int k) const {
        const std::size_t at = place(k, first);
        const bool has_origins = !origin_x.empty();
        return {last - first,
                {has_origins ? &origin_x[at] : origin.x.at + first,
                 has_origins ? &origin_y[at] : origin.y.at + first,
                 has_origins ? &origin_z[at] : origin.z.at + first},
                {&x[at], &y[at], &z[at]},
                time.at + first,
                RayKind::shadow};
    }
};

/// What belongs to the camera samples of a wave.
struct CameraSamples {
    Words pixel_hash, reversed_sample;  // of their random numbers

    void reserve(int samples) {
        pixel_hash.reserve(samples);
        reversed_sample.reserve(samples);
    }
};

/// Indices of vertices or paths.
struct IndexList {
    int count = 0;
    Words at;

    void reserve(int most) { at.reserve(most); }
    void add(int index) { at.at[count++] = index; }
};

/// Paths that left the scene, and the radiance that they bring.
struct EscapedQueue {
    IndexList paths;
    Floats3 light;  // by the place in the list

    void reserve(int most) {
        paths.reserve(most);
        light.reserve(most);
    }
};

}  // namespace carom::render
