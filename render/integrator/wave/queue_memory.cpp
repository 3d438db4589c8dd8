#include "render/integrator/wave/queue_memory.h"

#include <cstring>

namespace carom::render {
namespace {

RayKind kind_of(const PathQueue& paths) {
    return paths.vertex == 0 ? RayKind::primary : RayKind::secondary;
}

}  // namespace

void begin_shadows(int from, int vertices, int rays, ShadowQueue& shadows) {
    shadows.first = from;
    shadows.rays = rays;
    shadows.count = 0;
    const int most = rays > 0 ? kShadowRays / rays / kBeyondQueue * kBeyondQueue : vertices;
    shadows.last = std::min(vertices, from + std::max(most, kBeyondQueue));
    shadows.stride = shadows.last - from + kBeyondQueue;
}

void trace_shadows(const AccelerationStructure& structure, const ShadowQueue& shadows) {
    const bool has_origins = shadows.ray_origin.x.at != nullptr;
    const Floats3& origin = has_origins ? shadows.ray_origin : shadows.origin;
    for (int k = 0; k < shadows.rays; ++k) {
        const int ray = shadows.place(k, shadows.first);
        const int from = has_origins ? ray : shadows.first;
        const Floats3& to = shadows.direction;
        structure.test_occlusion({shadows.last - shadows.first,
                                  {origin.x.at + from, origin.y.at + from, origin.z.at + from},
                                  {to.x.at + ray, to.y.at + ray, to.z.at + ray},
                                  shadows.time.at + shadows.first,
                                  RayKind::shadow},
                                 shadows.t_max.at + ray);
    }
}

void append(PathQueue& more, PathQueue& to) {
    std::vector<const void*> from;
    each_pointer([&](auto*& at) { from.push_back(at); }, more);
    auto next = from.begin();
    const auto size = static_cast<std::size_t>(more.count) * sizeof(float);
    each_pointer([&](auto*& at) { std::memcpy(at + to.count, *next++, size); }, to);
    to.count += more.count;
}

RayBatch rays_of(const PathQueue& paths) {
    return {paths.count,
            {paths.origin.x.at, paths.origin.y.at, paths.origin.z.at},
            {paths.direction.x.at, paths.direction.y.at, paths.direction.z.at},
            paths.time.at,
            kind_of(paths)};
}

Path path_of(const PathQueue& paths, int i) {
    Path path{{paths.origin.get(i), paths.direction.get(i), 0, kInfinity, paths.time.at[i],
               kind_of(paths)}};
    path.throughput = paths.throughput.get(i);
    path.last.position = paths.last_position.get(i);
    path.last.normal = paths.last_normal.get(i);
    path.last.pdf = paths.pdf.at[i];
    path.last.is_delta = paths.is_delta.at[i] != 0;
    path.last.connects = paths.connects.at[i] != 0;
    const std::int32_t sphere = paths.connected_sphere.at[i];
    path.last.connected_sphere = sphere < 0 ? -1 : sphere & ~PathQueue::kPassedSphere;
    path.last.passed_sphere = sphere >= 0 && (sphere & PathQueue::kPassedSphere) != 0;
    path.last.all_lights = paths.vertex == 1;
    path.last.total_importance = paths.total_importance.at[i];
    path.vertex = paths.vertex;
    path.branch = static_cast<std::uint32_t>(paths.branch.at[i]);
    return path;
}

}  // namespace carom::render
