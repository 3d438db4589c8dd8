#include "lab/comparison/growth.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "lab/comparison/growth_rays.h"
#include "lab/comparison/lane_limit.h"
#include "lab/comparison/structure_timing.h"
#include "render/acceleration/flush_denormals.h"

namespace carom::pipeline {

namespace {

using render::AccelerationKind;
using render::FrameScene;
using render::Ray;

constexpr std::size_t kRays = 20'000;

void trace(const render::AccelerationStructure& structure, const std::vector<Ray>& rays) {
    for (const Ray& ray : rays) {
        static_cast<void>(hits(structure, ray));
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

void time_rays(const render::AccelerationStructure& structure, const RaysByKind& rays,
               double enough, const std::stop_token& stop, GrowthPoint& point) {
    const auto seconds_of_each = [&](const std::vector<Ray>& some, const auto& work) {
        return least_seconds(work, enough, stop) /
               static_cast<double>(std::max<std::size_t>(some.size(), 1));
    };
    for (std::size_t i = 0; i < rays.size(); ++i) {
        point.seconds_per_ray[i] = seconds_of_each(rays[i], [&] { trace(structure, rays[i]); });
    }
    // Batches of closest-hit queries and of occlusion tests, as in the product.
    std::vector<Ray> both = rays[0];
    both.insert(both.end(), rays[1].begin(), rays[1].end());
    const std::vector<RayArrays> batches = arrays_of(both);
    point.seconds_per_ray_of_batch = seconds_of_each(both, [&] {
        for (const RayArrays& batch : batches) {
            std::array<render::Hit, kBatchRays> hits;
            structure.closest_hits(batch.batch(), hits.data());
        }
    });
    const std::vector<RayArrays> shadow_batches = arrays_of(rays[2]);
    point.seconds_per_shadow_ray_of_batch = seconds_of_each(rays[2], [&] {
        for (const RayArrays& batch : shadow_batches) {
            RayArrays::Numbers t_max = batch.t_max();
            structure.test_occlusion(batch.batch(), t_max.data());
        }
    });
}

GrowthPoint point_of(AccelerationKind kind, const LaboratoryScene& scene, const RaysByKind& rays,
                     double enough, const std::stop_token& stop) {
    const render::FlushDenormals flush;
    GrowthPoint point;
    MeasuredScene measured(scene, kind);
    {
        const FrameScene frame = measured.frame();
        point.build_seconds = measured.structure().build_seconds();
        point.bytes = measured.structure().bytes();
        time_rays(frame.structure(), rays, enough, stop, point);
    }
    point.is_counted = render::can_count(kind);
    if (point.is_counted) {
        measured.structure().set(true);
        const FrameScene counting = measured.frame();
        for (const std::vector<Ray>& of_kind : rays) {
            check_stop(stop);
            trace(counting.structure(), of_kind);
        }
        point.tests = measured.structure().take_counts();
    }
    return point;
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

constexpr std::array<GrowingSceneFacts, 3> kScenes{
    {{GrowingScene::spheres, "spheres", "spheres", "spheres in a cube", sphere_cloud},
     {GrowingScene::mesh, "mesh", "triangles", "triangles of a torus knot", single_knot},
     {GrowingScene::balls, "balls", "balls", "balls in a cube, half of them moving", ball_cloud}}};

std::size_t shapes_of(const LaboratoryScene& scene) {
    const auto* mesh = std::get_if<render::MeshShape>(&scene.scene.objects.front().shape);
    return mesh != nullptr ? mesh->triangles.size() : scene.scene.objects.size();
}

/// A structure and the size of its vectors; 0: the processor's.
struct Variant {
    AccelerationKind kind = AccelerationKind::bvh;
    int lanes = 0;

    [[nodiscard]] std::string name() const {
        const std::string text(name_of(kind));
        return lanes == 0 ? text : text + ", " + std::to_string(lanes) + " lanes";
    }
};

std::vector<Variant> variants_of(const GrowthOptions& options) {
    std::vector<Variant> variants;
    for (const AccelerationKind kind : options.structures) {
        for (const int lanes : options.lanes) {
            variants.push_back({kind, lanes});
        }
        if (options.lanes.empty()) {
            variants.push_back({kind, 0});
        }
    }
    return variants;
}

void measure_size(std::size_t size, const GrowthOptions& options, const std::stop_token& stop,
                  const std::function<void(std::string_view)>& tell, Growth& growth) {
    const LaboratoryScene scene = facts(options.scene).make(size);
    const std::size_t shapes = shapes_of(scene);
    RaysByKind rays;
    {
        const MeasuredScene measured(scene, AccelerationKind::hybrid);
        const FrameScene frame = measured.frame();
        rays = growth_rays(frame.structure(), kRays);
    }
    const double tests = 3.0 * static_cast<double>(kRays) * static_cast<double>(shapes);
    const auto every =
        static_cast<std::size_t>(std::ceil(std::max(1.0, 20 * tests / options.most_tests)));
    for (const Variant& variant : variants_of(options)) {
        check_stop(stop);
        tell(name_of(variant.kind));
        const bool is_slow = is_linear(variant.kind);
        if (is_slow && every > kRays / 100) {
            continue;
        }
        std::optional<LaneLimit> limit;
        if (variant.lanes > 0) {
            limit.emplace(variant.lanes);
        }
        GrowthPoint point = point_of(variant.kind, scene, is_slow ? thinned(rays, every) : rays,
                                     options.enough_seconds, stop);
        point.name = variant.name();
        point.shapes = shapes;
        growth.points.push_back(std::move(point));
    }
}

}  // namespace

std::span<const GrowingSceneFacts> growing_scenes() {
    return kScenes;
}

const GrowingSceneFacts& facts(GrowingScene scene) {
    return *std::ranges::find(kScenes, scene, &GrowingSceneFacts::scene);
}

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
    for (const Variant& variant : variants_of(options)) {
        growth.structures.push_back(variant.name());
    }
    const std::vector<std::size_t> sizes = wanted_sizes(options.largest);
    try {
        double done = 0;
        for (const std::size_t size : sizes) {
            measure_size(
                size, options, stop,
                [&](std::string_view structure) {
                    const auto all = static_cast<double>(sizes.size() * growth.structures.size());
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
