#include "render/integrator/wave/hit_surfaces.h"

#include <algorithm>
#include <numeric>

#include "render/light/far_light.h"

namespace carom::render {

void begin_wave(const CameraRun& run, float pixel_spread, CameraSamples& samples,
                PathQueue& paths) {
    paths.count = run.count;
    paths.vertex = 0;
    const CameraBatch& batch = *run.batch;
    const auto copy = [&](const auto* from, auto& field) {
        std::copy_n(from + run.first, run.count, field.at);
    };
    copy(batch.pixel_hash, samples.pixel_hash);
    copy(batch.reversed_sample, samples.reversed_sample);
    copy(batch.origin[0], paths.origin.x);
    copy(batch.origin[1], paths.origin.y);
    copy(batch.origin[2], paths.origin.z);
    copy(batch.direction[0], paths.direction.x);
    copy(batch.direction[1], paths.direction.y);
    copy(batch.direction[2], paths.direction.z);
    copy(batch.time, paths.time);
    std::iota(paths.slot.at, paths.slot.at + paths.count, 0);
    std::fill_n(paths.branch.at, paths.count, 1);
    for (Floats* channel : {&paths.throughput.x, &paths.throughput.y, &paths.throughput.z}) {
        std::fill_n(channel->at, paths.count, 1.0F);
    }
    std::fill_n(paths.cone_width.at, paths.count, 0.0F);
    std::fill_n(paths.cone_spread.at, paths.count, pixel_spread);
}

HitSurfaces::HitSurfaces(const TransportScene& scene, const WaveScene& wave_scene,
                         const WaveKernels& kernels, int most_paths)
    : scene_(scene),
      wave_scene_(wave_scene),
      kernels_(kernels),
      hits_(static_cast<std::size_t>(most_paths + kBeyondQueue)) {}

const Hit* HitSurfaces::trace(const PathQueue& paths) {
    if (scene_.far == nullptr) {
        scene_.frame.structure().closest_hits(rays_of(paths), hits_.data());
    } else {
        scene_.frame.near().closest_hits(rays_of(paths), hits_.data());
        end_near(paths);
        trace_some(paths, scene_.frame.structure());
    }
    return hits_.data();
}

// Hits in the near box are the nearest ones of rays that begin in it. `some_` becomes those that
// look for more, and the others find nothing.
void HitSurfaces::end_near(const PathQueue& paths) {
    const FarGrid& grid = scene_.far->grid();
    some_.clear();
    for (int i = 0; i < paths.count; ++i) {
        const V3f origin = paths.origin.get(i);
        Hit& hit = hits_[static_cast<std::size_t>(i)];
        const bool leaves = hit.t > grid.way_out(origin, paths.direction.get(i));
        const bool is_seen = paths.vertex == 0 || paths.is_delta.at[i] != 0;
        if (is_seen && (leaves || grid.is_far(origin))) {
            some_.push_back(i);
        } else if (leaves) {
            hit = Hit{};
        }
    }
}

void HitSurfaces::trace_some(const PathQueue& paths, const AccelerationStructure& structure) {
    const std::size_t size = some_.size() + RayBatch::kBeyond;
    for (std::vector<float>& numbers : rays_) {
        numbers.resize(std::max(numbers.size(), size));
    }
    hits_of_some_.resize(std::max(hits_of_some_.size(), size));
    for (std::size_t k = 0; k < some_.size(); ++k) {
        const int i = some_[k];
        const V3f origin = paths.origin.get(i);
        const V3f direction = paths.direction.get(i);
        for (int axis = 0; axis < 3; ++axis) {
            rays_[static_cast<std::size_t>(axis)][k] = origin[axis];
            rays_[static_cast<std::size_t>(axis) + 3][k] = direction[axis];
        }
        rays_[6][k] = paths.time.at[i];
    }
    structure.closest_hits({static_cast<int>(some_.size()),
                            {rays_[0].data(), rays_[1].data(), rays_[2].data()},
                            {rays_[3].data(), rays_[4].data(), rays_[5].data()},
                            rays_[6].data()},
                           hits_of_some_.data());
    for (std::size_t k = 0; k < some_.size(); ++k) {
        hits_[static_cast<std::size_t>(some_[k])] = hits_of_some_[k];
    }
}

void HitSurfaces::find(const PathQueue& paths, const IndexList& hit_paths, SurfaceQueue& vertices) {
    sort(hit_paths, vertices);
    int first = 0;
    for (int k = 0; k < wave_scene_.groups.count(); ++k) {
        const WaveGroup& group = wave_scene_.groups[k];
        const int last = group_ends_[static_cast<std::size_t>(k)];
        if (first < last) {
            kernels_.resolve_surfaces({wave_scene_, group, paths, hits_.data(), vertices, last},
                                      first);
        }
        first = last;
    }
}

// Makes vertices of the hits, one group after the other, in each of them in the order of the paths.
void HitSurfaces::sort(const IndexList& hit_paths, SurfaceQueue& vertices) {
    const List<std::uint16_t>& groups = wave_scene_.group_of_object;
    std::vector<int>& ends = group_ends_;
    ends.assign(static_cast<std::size_t>(wave_scene_.groups.size()) + 1, 0);
    for (int k = 0; k < hit_paths.count; ++k) {
        ends[groups[hits_[static_cast<std::size_t>(hit_paths.at.at[k])].object] + 1u] += 1;
    }
    std::partial_sum(ends.begin(), ends.end(), ends.begin());
    vertices.count = hit_paths.count;
    // Each group's end grows from its beginning.
    for (int k = 0; k < hit_paths.count; ++k) {
        const int path = hit_paths.at.at[k];
        const Hit& hit = hits_[static_cast<std::size_t>(path)];
        const std::uint16_t group = groups[hit.object];
        const int i = ends[group]++;
        vertices.path.at[i] = path;
        vertices.object.at[i] = static_cast<std::int32_t>(hit.object);
        vertices.material.at[i] = static_cast<std::int32_t>(wave_scene_.groups[group].material);
        vertices.distance.at[i] = hit.t;
    }
}

}  // namespace carom::render
