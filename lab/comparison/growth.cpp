#include "lab/comparison/growth.h"

#include <algorithm>
#include <cmath>

#include "core/cpu_time.h"
#include "core/error.h"
#include "lab/comparison/frame_meter.h"
#include "lab/comparison/growth_rays.h"
#include "lab/structures/make_structure.h"
#include "render/acceleration/flush_denormals.h"
#include "render/frame_scene/frame_scene.h"
#include "render/frame_scene/static_geometry.h"

namespace carom::pipeline {

namespace {

using render::AccelerationKind;
using render::FrameScene;
using render::Ray;
using render::StaticGeometry;
using RaysByKind = std::array<std::vector<Ray>, 3>;

constexpr std::size_t kRays = 20'000;

void check_stop(const std::stop_token& stop) {
    if (stop.stop_requested()) {
        throw Stopped();
    }
}

StaticGeometry geometry_of(const LaboratoryScene& scene, AccelerationKind kind) {
    render::RenderSettings settings = scene.settings;
    settings.acceleration = kind;
    return {scene.scene, settings, render::make_structure};
}

/// The number of rays that hit something.
std::size_t trace(const render::AccelerationStructure& structure, std::span<const Ray> rays) {
    std::size_t hits = 0;
    for (const Ray& ray : rays) {
        render::Hit hit;
        const bool any = ray.kind == render::RayKind::shadow;
        hits += (any ? structure.any_hit(ray) : structure.closest_hit(ray, hit)) ? 1 : 0;
    }
    return hits;
}

/// Batches of closest-hit queries, as in the product.
void trace(const render::AccelerationStructure& structure, const std::vector<RayArrays>& arrays) {
    for (const RayArrays& rays : arrays) {
        std::array<render::Hit, kBatchRays> hits;
        structure.closest_hits(rays.batch(), hits.data());
    }
}

std::vector<RayArrays> arrays_of(std::span<const Ray> rays) {
    std::vector<RayArrays> arrays;
    for (std::size_t first = 0; first < rays.size(); first += kBatchRays) {
        arrays.emplace_back(
            rays.subspan(first, std::min<std::size_t>(kBatchRays, rays.size() - first)));
    }
    return arrays;
}

/// CPU time of `work`, the least of several runs, because other load on the machine only slows it
/// down.
template <class Work>
double least_seconds(const Work& work, double enough, const std::stop_token& stop) {
    constexpr int kMost = 12;
    double least = 1e300;
    double all = 0;
    for (int i = 0; i < kMost && (i < 2 || all < enough); ++i) {
        check_stop(stop);
        const double start = process_cpu_seconds();
        work();
        const double seconds = process_cpu_seconds() - start;
        all += seconds;
        least = std::min(least, seconds);
    }
    return least;
}

/// A scene at its own time.
FrameScene frame_of(const StaticGeometry& geometry, const LaboratoryScene& scene,
                    const render::StructureOptions& options = {}) {
    return FrameScene(geometry, scene.tracks, scene.frame.scene_open, scene.frame.scene_close,
                      options);
}

void time_rays(const render::AccelerationStructure& structure, const RaysByKind& rays,
               double enough, const std::stop_token& stop, GrowthPoint& point) {
    const auto per_ray = [](double seconds, std::size_t count) {
        return count == 0 ? 0 : seconds / static_cast<double>(count);
    };
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const auto one_by_one = [&] { static_cast<void>(trace(structure, rays[i])); };
        point.seconds_per_ray[i] = per_ray(least_seconds(one_by_one, enough, stop), rays[i].size());
    }
    std::vector<Ray> both = rays[0];
    both.insert(both.end(), rays[1].begin(), rays[1].end());
    const std::vector<RayArrays> arrays = arrays_of(both);
    const auto in_batches = [&] { trace(structure, arrays); };
    point.seconds_per_ray_of_batch = per_ray(least_seconds(in_batches, enough, stop), both.size());
}

GrowthPoint point_of(AccelerationKind kind, const LaboratoryScene& scene, std::size_t shapes,
                     const RaysByKind& rays, double enough, const std::stop_token& stop) {
    const render::FlushDenormals flush;
    GrowthPoint point;
    point.name = name_of(kind);
    point.shapes = shapes;
    const StaticGeometry geometry = geometry_of(scene, kind);
    {
        const FrameScene frame = frame_of(geometry, scene);
        point.build_seconds = frame.cost().build_seconds;
        point.bytes = frame.cost().bytes;
        time_rays(frame.structure(), rays, enough, stop, point);
    }
    point.is_counted = FrameMeter::can_count(kind);
    if (point.is_counted) {
        const FrameScene counting = frame_of(geometry, scene, {.counts = true});
        for (const std::vector<Ray>& of_kind : rays) {
            check_stop(stop);
            static_cast<void>(trace(counting.structure(), of_kind));
        }
        point.tests = counting.cost().counts;
    }
    return point;
}

/// Every `every`th ray: few enough for brute force, and enough for means.
RaysByKind thinned(const RaysByKind& rays, std::size_t every) {
    RaysByKind some;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        for (std::size_t k = 0; k < rays[i].size(); k += every) {
            some[i].push_back(rays[i][k]);
        }
    }
    return some;
}

std::vector<std::size_t> wanted_sizes(std::size_t largest) {
    std::vector<std::size_t> sizes;
    for (int step = 2; step <= 40; ++step) {
        const double size = std::pow(10.0, 0.5 * step);
        if (size > 1.001 * static_cast<double>(largest)) {
            break;
        }
        sizes.push_back(static_cast<std::size_t>(std::llround(size)));
    }
    return sizes;
}

LaboratoryScene scene_of(GrowingScene scene, std::size_t size) {
    switch (scene) {
        case GrowingScene::spheres:
            return sphere_cloud(size);
        case GrowingScene::balls:
            return ball_cloud(size);
        case GrowingScene::mesh:
            break;
    }
    return single_knot(size);
}

std::size_t shapes_of(const LaboratoryScene& scene) {
    const auto* mesh = std::get_if<render::MeshShape>(&scene.scene.objects.front().shape);
    return mesh != nullptr ? mesh->triangles.size() : scene.scene.objects.size();
}

void measure_size(std::size_t size, const GrowthOptions& options, const std::stop_token& stop,
                  const std::function<void(std::string_view)>& tell, Growth& growth) {
    const LaboratoryScene scene = scene_of(options.scene, size);
    const std::size_t shapes = shapes_of(scene);
    RaysByKind rays;
    {
        const StaticGeometry geometry = geometry_of(scene, AccelerationKind::wide_bvh);
        const FrameScene frame = frame_of(geometry, scene);
        rays = growth_rays(frame.structure(), kRays);
    }
    const double tests = 3.0 * static_cast<double>(kRays) * static_cast<double>(shapes);
    const auto every =
        static_cast<std::size_t>(std::ceil(std::max(1.0, 20 * tests / options.most_tests)));
    for (const AccelerationKind kind : options.structures) {
        check_stop(stop);
        tell(name_of(kind));
        const bool is_brute = kind == AccelerationKind::brute_force;
        if (is_brute && every > kRays / 100) {
            continue;
        }
        growth.points.push_back(point_of(kind, scene, shapes,
                                         is_brute ? thinned(rays, every) : rays,
                                         options.enough_seconds, stop));
    }
}

}  // namespace

std::vector<std::size_t> Growth::sizes() const {
    std::vector<std::size_t> sizes;
    for (const GrowthPoint& point : points) {
        if (sizes.empty() || sizes.back() != point.shapes) {
            sizes.push_back(point.shapes);
        }
    }
    return sizes;
}

const GrowthPoint* Growth::point(const std::string& name, std::size_t shapes) const {
    const auto found = std::ranges::find_if(points, [&](const GrowthPoint& point) {
        return point.name == name && point.shapes == shapes;
    });
    return found == points.end() ? nullptr : &*found;
}

Growth measure_growth(const GrowthOptions& options, const ComparisonProgress& progress,
                      const std::stop_token& stop) {
    Growth growth;
    growth.scene = options.scene;
    for (const AccelerationKind kind : options.structures) {
        growth.structures.emplace_back(name_of(kind));
    }
    const std::vector<std::size_t> sizes = wanted_sizes(options.largest);
    try {
        double done = 0;
        for (const std::size_t size : sizes) {
            measure_size(
                size, options, stop,
                [&](std::string_view structure) {
                    const auto all = static_cast<double>(sizes.size() * options.structures.size());
                    progress(structure, std::min(1.0, done / all));
                    done += 1;
                },
                growth);
        }
        growth.is_whole = true;
    } catch (const Stopped&) {
        // The points measured before the stop are the result.
    }
    return growth;
}

}  // namespace carom::pipeline
