// Rays per second on one thread: the hybrid structure against Embree alone, in one run on the same
// rays. Before timing, both are checked for the same hits.
//
//   ray_bench --benchmark_repetitions=5 --benchmark_report_aggregates_only=true
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <memory>

#include <benchmark/benchmark.h>

#include "bench/ray_scene.h"
#include "lab/structures/make_structure.h"
#include "render/acceleration/flush_denormals.h"
#include "render/acceleration/hybrid_structure.h"
#include "render/acceleration/triangle_scene.h"
#include "render/acceleration/wide_tree.h"
#include "render/camera/thin_lens_camera.h"
#include "render/sampling/sampler.h"
#include "render/threads/thread_arena.h"
#include "tests/render/acceleration/owned_batch.h"

namespace carom::bench {
namespace {

using namespace render;

struct Built {
    explicit Built(bool with_knot, AccelerationKind kind)
        : shot(make_table_shot(with_knot)),
          geometry(shot.scene, {}, maker(kind)),
          frame(geometry, shot.tracks, shot.scene_open, shot.scene_close) {}

    static StructureMaker maker(AccelerationKind kind) {
        return named_structure(std::string(name_of(kind)));
    }

    TableShot shot;
    StaticGeometry geometry;
    FrameScene frame;
};

struct Scenes {
    std::unique_ptr<Built> hybrid;
    std::unique_ptr<Built> embree;
    RaySets rays;
};

void check_same_hits(const Scenes& scenes, const std::vector<Ray>& rays) {
    std::size_t differing = 0;
    for (const Ray& ray : rays) {
        Hit a;
        Hit b;
        const bool found = scenes.hybrid->frame.structure().closest_hit(ray, a);
        const bool same = found == scenes.embree->frame.structure().closest_hit(ray, b);
        differing += same && a.object == b.object && a.t == b.t ? 0 : 1;
    }
    if (differing > 0) {
        std::fprintf(stderr, "%zu of %zu rays differ between the structures\n", differing,
                     rays.size());
        std::exit(1);
    }
}

const Scenes& scenes(bool with_knot) {
    static std::map<bool, Scenes> built;
    Scenes& result = built[with_knot];
    if (!result.hybrid) {
        result.hybrid = std::make_unique<Built>(with_knot, AccelerationKind::hybrid);
        result.embree = std::make_unique<Built>(with_knot, AccelerationKind::embree);
        result.rays = make_ray_sets(result.hybrid->frame);
        check_same_hits(result, result.rays.primary);
        check_same_hits(result, result.rays.secondary);
    }
    return result;
}

const AccelerationStructure& structure_of(const Scenes& built, AccelerationKind kind) {
    return (kind == AccelerationKind::hybrid ? built.hybrid : built.embree)->frame.structure();
}

void count_rays(benchmark::State& state, std::size_t rays) {
    state.counters["rays"] =
        benchmark::Counter(static_cast<double>(rays) * static_cast<double>(state.iterations()),
                           benchmark::Counter::kIsRate);
}

void closest(benchmark::State& state, bool with_knot, AccelerationKind kind,
             std::vector<Ray> RaySets::*set) {
    const FlushDenormals mode;
    const Scenes& built = scenes(with_knot);
    const AccelerationStructure& structure = structure_of(built, kind);
    const std::vector<Ray>& rays = built.rays.*set;
    for (auto _ : state) {
        float sum = 0;
        for (const Ray& ray : rays) {
            Hit hit;
            sum += structure.closest_hit(ray, hit) ? hit.t : 0;
        }
        benchmark::DoNotOptimize(sum);
    }
    count_rays(state, rays.size());
}

void occluded(benchmark::State& state, bool with_knot, AccelerationKind kind) {
    const FlushDenormals mode;
    const Scenes& built = scenes(with_knot);
    const AccelerationStructure& structure = structure_of(built, kind);
    for (auto _ : state) {
        int blocked = 0;
        for (const Ray& ray : built.rays.shadow) {
            blocked += structure.any_hit(ray) ? 1 : 0;
        }
        benchmark::DoNotOptimize(blocked);
    }
    count_rays(state, built.rays.shadow.size());
}

/// Hits with surface points, as an integrator needs them.
void surfaces(benchmark::State& state, bool with_knot) {
    const FlushDenormals mode;
    const Scenes& built = scenes(with_knot);
    const FrameScene& frame = built.hybrid->frame;
    for (auto _ : state) {
        float sum = 0;
        for (const Ray& ray : built.rays.primary) {
            Hit hit;
            if (frame.structure().closest_hit(ray, hit)) {
                sum += frame.surface_at(ray, hit).position.x;
            }
        }
        benchmark::DoNotOptimize(sum);
    }
    count_rays(state, built.rays.primary.size());
}

void camera_rays(benchmark::State& state, bool moving) {
    CameraState open;
    CameraState close = open;
    close.position.x += moving ? 0.01 : 0;
    open.lens_radius = close.lens_radius = 0.01;
    const ThinLensCamera camera(open, close, 640, 360, 0.2, PixelFilter::blackman_harris, 1.5);
    std::uint32_t i = 0;
    for (auto _ : state) {
        const SampleStream stream(1, i % 640, i / 640, i);
        benchmark::DoNotOptimize(
            camera.ray(static_cast<int>(i % 640), 100, stream.camera_sample()));
        ++i;
    }
    count_rays(state, 1);
}

void next_4d(benchmark::State& state) {
    SampleStream stream(1, 2, 3, 4);
    for (auto _ : state) {
        benchmark::DoNotOptimize(stream.next_4d());
    }
}

void frame_set_up(benchmark::State& state, bool with_knot, AccelerationKind kind) {
    const TableShot shot = make_table_shot(with_knot);
    const StaticGeometry geometry(shot.scene, {}, Built::maker(kind));
    for (auto _ : state) {
        const FrameScene frame(geometry, shot.tracks, shot.scene_open, shot.scene_close);
        benchmark::DoNotOptimize(&frame);
    }
}

/// Equal meshes: kept once at rest and in motion, and for comparison a copy of each.
enum class Equal { copied, at_rest, moving };

/// The bytes of the structure, and nearest hits of secondary rays, 64 at a time.
void equal_meshes(benchmark::State& state, Equal equal) {
    const FlushDenormals mode;
    const TableShot shot = make_equal_meshes(equal == Equal::moving);
    StructureMaker maker;
    if (equal == Equal::copied) {
        maker = [](const ShapeSet& shapes, std::span<const MeshEntry> meshes) {
            ShapeSet all = shapes;
            all.meshes = std::make_shared<const TriangleScene>(meshes);
            return std::make_unique<HybridStructure>(all);
        };
    }
    const StaticGeometry geometry(shot.scene, {}, maker);
    const FrameScene frame(geometry, shot.tracks, shot.scene_open, shot.scene_close);
    const std::vector<Ray> rays = make_ray_sets(frame).secondary;
    const test::OwnedBatch batch(rays);
    std::vector<Hit> hits(rays.size());
    for (auto _ : state) {
        frame.structure().closest_hits(batch.rays(), hits.data());
        benchmark::DoNotOptimize(hits.data());
    }
    count_rays(state, rays.size());
    const auto& structure = dynamic_cast<const HybridStructure&>(frame.structure());
    state.counters["structure_MB"] = static_cast<double>(structure.bytes()) / 1e6;
}

/// A tree over many boxes.
void build_tree(benchmark::State& state, int threads) {
    std::vector<MovingBounds> boxes;
    for (int i = 0; i < 500'000; ++i) {
        const V3f low(std::sin(1.3f * static_cast<float>(i)),
                      std::sin(2.1f * static_cast<float>(i)),
                      std::cos(3.7f * static_cast<float>(i)));
        boxes.push_back({{low, low + V3f(0.01f)}, {low, low + V3f(0.01f)}});
    }
    ThreadArena arena(threads);
    for (auto _ : state) {
        arena.execute([&] { benchmark::DoNotOptimize(build_wide_tree(boxes).nodes.data()); });
    }
}

void register_all() {
    const struct {
        const char* name;
        AccelerationKind kind;
    } kinds[] = {{"hybrid", AccelerationKind::hybrid}, {"embree", AccelerationKind::embree}};
    for (const bool knot : {false, true}) {
        const std::string scene = knot ? "table_and_knot" : "table";
        for (const auto& kind : kinds) {
            const AccelerationKind k = kind.kind;
            const auto name = [&](const std::string& rays) {
                return scene + "/" + rays + "/" + kind.name;
            };
            const auto add_closest = [&](const char* rays, std::vector<Ray> RaySets::*set) {
                benchmark::RegisterBenchmark(name(rays).c_str(), [=](benchmark::State& state) {
                    closest(state, knot, k, set);
                });
            };
            add_closest("primary", &RaySets::primary);
            add_closest("secondary", &RaySets::secondary);
            add_closest("shuffled", &RaySets::shuffled);
            benchmark::RegisterBenchmark(
                name("shadow").c_str(), [=](benchmark::State& state) { occluded(state, knot, k); });
            benchmark::RegisterBenchmark(
                name("frame_set_up").c_str(),
                [=](benchmark::State& state) { frame_set_up(state, knot, k); });
        }
        benchmark::RegisterBenchmark((scene + "/primary_with_surface/hybrid").c_str(),
                                     [=](benchmark::State& state) { surfaces(state, knot); });
    }
    for (const bool moving : {false, true}) {
        benchmark::RegisterBenchmark(moving ? "camera_ray/moving" : "camera_ray/still",
                                     [=](benchmark::State& state) { camera_rays(state, moving); });
    }
    benchmark::RegisterBenchmark("next_4d", next_4d);
    for (const int threads : {1, 0}) {
        benchmark::RegisterBenchmark(threads == 1 ? "build_tree/one_thread" : "build_tree/all",
                                     [=](benchmark::State& state) { build_tree(state, threads); })
            ->UseRealTime();
    }
    const std::pair<const char*, Equal> equals[] = {
        {"copied", Equal::copied}, {"at_rest", Equal::at_rest}, {"moving", Equal::moving}};
    for (const auto& [name, equal] : equals) {
        benchmark::RegisterBenchmark(
            (std::string("200_equal_meshes/secondary/") + name).c_str(),
            [equal = equal](benchmark::State& state) { equal_meshes(state, equal); });
    }
}

}  // namespace
}  // namespace carom::bench

int main(int argc, char** argv) {
    carom::bench::register_all();
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) {
        return 2;
    }
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
