// How cost grows with a scene: balls from 16 to 100 000, meshes from 1 000 to 5 million triangles.
// Prints tables in Markdown and draws a chart. All times are CPU time, of all threads.
//
//   growth --plot docs/developers/images/growth.svg
#include <algorithm>
#include <cstdio>
#include <exception>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <tbb/task_arena.h>

#include "bench/growth_scenes.h"
#include "bench/line_chart.h"
#include "core/cpu_time.h"
#include "render/acceleration/embree_structure.h"
#include "render/acceleration/flush_denormals.h"
#include "render/acceleration/hybrid_structure.h"
#include "render/acceleration/triangle_scene.h"
#include "render/geometry/rigid_motion.h"

namespace carom::bench {

namespace {

using namespace render;

template <class Work>
double timed(const Work& work) {
    const double start = process_cpu_seconds();
    work();
    return process_cpu_seconds() - start;
}

/// The balls of a cloud as the structures take them.
ShapeSet shapes_of(const GrowthScene& scene) {
    ShapeSet shapes;
    std::size_t next_track = 0;
    for (std::uint32_t i = 0; i < scene.builder.scene.objects.size(); ++i) {
        const ObjectDescription& object = scene.builder.scene.objects[i];
        const auto* ball = std::get_if<SphereShape>(&object.shape);
        if (ball == nullptr) {
            continue;
        }
        SphereStretch sphere;
        sphere.radius = static_cast<float>(ball->radius);
        sphere.object = i;
        if (object.track.empty()) {
            for (int axis = 0; axis < 3; ++axis) {
                sphere.path.c[0][axis] = static_cast<float>(object.world_from_object[3][axis]);
            }
            shapes.add_sphere(sphere);
            continue;
        }
        const RigidMotion motion(scene.tracks[next_track++], scene.frame.scene_open,
                                 scene.frame.scene_close);
        const auto path = motion.path();
        for (std::size_t k = 0; k < path.size(); ++k) {
            sphere.path = path[k];
            sphere.start = k == 0 ? -kInfinity : path[k].start;
            sphere.end = k + 1 == path.size() ? kInfinity : path[k].end;
            shapes.add_sphere(sphere);
        }
    }
    return shapes;
}

/// Rays side by side, as waves of paths ask for them.
class RayWave {
  public:
    static constexpr int kRays = 64;
    static constexpr int kRoom = kRays + 16;

    RayWave(const std::vector<Ray>& rays, std::size_t first) {
        for (int i = 0; i < kRays; ++i) {
            const Ray& ray = rays[(first + static_cast<std::size_t>(i)) % rays.size()];
            for (int axis = 0; axis < 3; ++axis) {
                numbers_[axis][i] = ray.origin[axis];
                numbers_[3 + axis][i] = ray.direction[axis];
            }
            numbers_[6][i] = ray.time;
        }
    }
    [[nodiscard]] RayBatch batch() const {
        return {kRays,
                {numbers_[0], numbers_[1], numbers_[2]},
                {numbers_[3], numbers_[4], numbers_[5]},
                numbers_[6]};
    }

  private:
    float numbers_[7][kRoom] = {};
};

std::vector<RayWave> make_waves(const std::vector<Ray>& rays) {
    std::vector<RayWave> waves;
    for (std::size_t first = 0; first < rays.size(); first += RayWave::kRays) {
        waves.emplace_back(rays, first);
    }
    return waves;
}

/// Millions of nearest hits a second; at least a tenth of a second's worth of rays.
double ray_rate(const AccelerationStructure& structure, const std::vector<RayWave>& waves) {
    const FlushDenormals flush;
    std::size_t asked = 0;
    float sum = 0;
    const double seconds = timed([&] {
        const double start = process_cpu_seconds();
        do {
            for (int i = 0; i < 8; ++i, ++asked) {
                Hit hits[RayWave::kRoom];
                structure.closest_hits(waves[asked % waves.size()].batch(), hits);
                sum += hits[0].object != kNoObject ? hits[0].t : 0;
            }
        } while (process_cpu_seconds() - start < 0.1);
    });
    return sum > 0 ? 1e-6 * RayWave::kRays * static_cast<double>(asked) / seconds : 0;
}

/// The best of several, each structure in turn: what else the machine does only ever slows.
std::vector<double> best_rates(const std::vector<const AccelerationStructure*>& structures,
                               const std::vector<RayWave>& waves) {
    std::vector<double> best(structures.size(), 0);
    for (int repeat = 0; repeat < 5; ++repeat) {
        for (std::size_t i = 0; i < structures.size(); ++i) {
            best[i] = std::max(best[i], ray_rate(*structures[i], waves));
        }
    }
    return best;
}

RenderSettings settings_of(int width, int height, int samples) {
    RenderSettings settings = test::small_settings(width, height, samples);
    settings.max_bounces = 4;
    return settings;
}

Film render(const GrowthScene& scene, const PreparedScene& prepared, const RenderSettings& settings,
            int threads) {
    Film film;
    tbb::task_arena(threads).execute(
        [&] { film = render_frame(prepared, scene.tracks, scene.frame, settings); });
    return film;
}

struct FrameCost {
    double prepare = 0;      // s, once for a shot
    double first_pixel = 0;  // s, from the prepared scene to the end of one pixel
    double rate = 0;         // million rays a second, all shading counted
};

FrameCost frame_cost(const GrowthScene& scene) {
    FrameCost cost{1e9, 1e9, 0};
    const RenderSettings one = settings_of(1, 1, 1);
    const RenderSettings many = settings_of(256, 144, 4);
    for (int repeat = 0; repeat < 3; ++repeat) {
        std::unique_ptr<PreparedScene> prepared;
        cost.prepare = std::min(
            cost.prepare,
            timed([&] { prepared = std::make_unique<PreparedScene>(scene.builder.scene, one); }));
        const double first = timed([&] { render(scene, *prepared, one, 1); });
        cost.first_pixel = std::min(cost.first_pixel, first);
        Film film;
        const double seconds = timed([&] { film = render(scene, *prepared, many, 1); });
        const RenderStatistics& counts = film.statistics;
        const auto rays =
            static_cast<double>(counts.camera_rays + counts.scattered_rays + counts.shadow_rays);
        cost.rate = std::max(cost.rate, 1e-6 * rays / (seconds - first));
    }
    return cost;
}

void add_balls(const std::vector<int>& sizes, Chart& chart) {
    std::printf(
        "| balls | shot, ms | first pixel, ms | tree | loops | Embree | path tracing |\n"
        "|---|---|---|---|---|---|---|\n");
    const std::vector<RayWave> waves = make_waves(make_rays(20'000));
    ChartLine tree_line{"tree", {}};
    ChartLine loop_line{"loops", {}};
    ChartLine embree_line{"Embree", {}};
    ChartLine path_line{"path tracing, balls", {}};
    for (const int size : sizes) {
        const GrowthScene scene = make_ball_cloud(size);
        const ShapeSet shapes = shapes_of(scene);
        const HybridStructure tree(shapes, 0);
        const HybridStructure loops(shapes, loop_cost(shapes) + 1);
        const EmbreeStructure embree(make_embree_device(), shapes, {});
        const std::vector<double> rates = best_rates({&tree, &loops, &embree}, waves);
        const FrameCost cost = frame_cost(scene);
        std::printf("| %d | %.2f | %.2f | %.2f | %.3f | %.2f | %.2f |\n", size, 1e3 * cost.prepare,
                    1e3 * cost.first_pixel, rates[0], rates[1], rates[2], cost.rate);
        std::fflush(stdout);
        tree_line.points.emplace_back(size, rates[0]);
        loop_line.points.emplace_back(size, rates[1]);
        embree_line.points.emplace_back(size, rates[2]);
        path_line.points.emplace_back(size, cost.rate);
    }
    chart.lines.insert(chart.lines.end(), {tree_line, loop_line, embree_line, path_line});
}

void add_meshes(const std::vector<int>& sizes, Chart& chart) {
    std::printf("\n| triangles | shot, ms | first pixel, ms | path tracing |\n|---|---|---|---|\n");
    ChartLine line{"path tracing, mesh", {}};
    for (const int size : sizes) {
        const GrowthScene scene = make_mesh(size);
        const FrameCost cost = frame_cost(scene);
        std::printf("| %d | %.1f | %.2f | %.2f |\n", size, 1e3 * cost.prepare,
                    1e3 * cost.first_pixel, cost.rate);
        std::fflush(stdout);
        line.points.emplace_back(size, cost.rate);
    }
    chart.lines.push_back(line);
}

/// One and two threads in turn; the middle one of the ratios of neighbours.
void compare_threads(const std::string& name, const GrowthScene& scene, int samples) {
    const RenderSettings settings = settings_of(320, 180, samples);
    const PreparedScene prepared(scene.builder.scene, settings);
    std::vector<double> ratios;
    double one_thread = 1e9;
    double two_threads = 1e9;
    for (int repeat = 0; repeat < 9; ++repeat) {
        const double one = timed([&] { render(scene, prepared, settings, 1); });
        const double two = timed([&] { render(scene, prepared, settings, 2); });
        ratios.push_back(two / one);
        one_thread = std::min(one_thread, one);
        two_threads = std::min(two_threads, two);
    }
    std::sort(ratios.begin(), ratios.end());
    std::printf("| %s | %.3f | %.3f | %+.1f %% | %+.1f %% |\n", name.c_str(), one_thread,
                two_threads, 100 * (two_threads / one_thread - 1),
                100 * (ratios[ratios.size() / 2] - 1));
    std::fflush(stdout);
}

void add_threads(bool quick) {
    std::printf(
        "\n| scene | one thread, s | two threads, s | least against least | middle ratio "
        "|\n|---|---|---|---|---|\n");
    compare_threads("16 balls", make_ball_cloud(16), 64);
    compare_threads("1000 balls", make_ball_cloud(1'000), 16);
    if (!quick) {
        compare_threads("100000 balls", make_ball_cloud(100'000), 8);
        compare_threads("1000000 triangles", make_mesh(1'000'000), 16);
    }
}

}  // namespace

}  // namespace carom::bench

int main(int argc, char** argv) {
    CLI::App app("How cost grows with the number of balls and triangles");
    std::string plot;
    std::string only;
    bool quick = false;
    app.add_option("--plot", plot, "write a chart to this SVG");
    app.add_option("--only", only, "balls, meshes or threads")
        ->check(CLI::IsMember({"balls", "meshes", "threads"}));
    app.add_flag("--quick", quick, "nothing above 10 000 balls and 100 000 triangles");
    CLI11_PARSE(app, argc, argv);
    using namespace carom::bench;
    try {
        std::vector<int> balls{16, 32, 64, 128, 256, 512, 1'000, 10'000};
        std::vector<int> triangles{1'000, 10'000, 100'000};
        if (!quick) {
            balls.push_back(100'000);
            triangles.insert(triangles.end(), {1'000'000, 5'000'000});
        }
        Chart chart{
            "Rays a second on one thread", "balls or triangles", "million rays a second", {}};
        const auto wanted = [&](const char* part) { return only.empty() || only == part; };
        if (wanted("balls")) {
            add_balls(balls, chart);
        }
        if (wanted("meshes")) {
            add_meshes(triangles, chart);
        }
        if (wanted("threads")) {
            add_threads(quick);
        }
        if (!plot.empty() && !chart.lines.empty()) {
            write_chart(chart, plot);
        }
    } catch (const std::exception& error) {
        std::fprintf(stderr, "growth: %s\n", error.what());
        return 1;
    }
    return 0;
}
