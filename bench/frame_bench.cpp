// The cost of a frame: a table with sixteen balls, half of them moving, under a lamp, a bulb and a
// dim sky; 640 x 360 pixels, 16 samples, thin lens, four bounces. CPU time counts all threads.
#include <filesystem>

#include <Imath/ImathVec.h>
#include <OpenImageIO/imageio.h>
#include <OpenImageIO/texture.h>
#include <benchmark/benchmark.h>
#include <fmt/core.h>

#include "render/frame/frame.h"
#include "render/texture/image.h"
#include "render/texture/scalar_kernels.h"
#include "tests/render/scene_builder.h"

namespace carom::render {
namespace {

constexpr double kRadius = 0.028575;
constexpr double kShutter = 1.0 / 48;  // s

struct Table {
    test::SceneBuilder builder;
    std::vector<sim::Track> tracks;
    FrameInput frame;
};

StandardMaterial ball_material(int number, bool textured) {
    StandardMaterial material;
    material.coat.weight = 1;
    const Vec3 colour(0.1 + 0.05 * number, 0.7 - 0.04 * number, 0.2);
    if (textured) {
        material.base = BallTexture{.colour = colour, .striped = number > 8, .number = number};
    } else {
        material.base = colour;
    }
    return material;
}

void add_balls(Table& table, bool textured) {
    for (int i = 0; i < 16; ++i) {
        const std::string name = fmt::format("ball {}", i);
        table.builder.material(name, ball_material(i, textured));
        table.builder.sphere(name, kRadius, Vec3(0, 0, 0), name, name);
        const Vec3 place(0.35 + 0.075 * (i % 4), -0.2 + 0.09 * (i / 4) + 0.03 * (i % 3), kRadius);
        if (i % 2 == 0) {
            table.tracks.push_back(test::resting_track(name, place));
        } else {
            const Vec3 velocity(0.4 + 0.1 * i, 0.5 - 0.1 * i, 0);
            table.tracks.push_back(
                test::straight_track(name, place, place + velocity * kShutter, 0, kShutter));
        }
    }
}

void add_furniture(test::SceneBuilder& builder, bool textured) {
    StandardMaterial cloth;
    StandardMaterial wood;
    if (textured) {
        cloth.base = ClothTexture{};
        cloth.sheen = 0.2;
        cloth.bump = 0.5;
        wood.base = WoodTexture{};
        wood.coat = {1, 1.5, 0.3};
    } else {
        cloth.base = Vec3(0.05, 0.28, 0.12);
        wood.base = Vec3(0.22, 0.09, 0.035);
    }
    builder.material("cloth", cloth).material("wood", wood).diffuse("floor", 0.06);
    builder.object("bed", BoxShape{Vec3(2.64, 1.37, 0.03)}, Vec3(0, 0, -0.015), "cloth");
    for (const double side : {-1.0, 1.0}) {
        builder.object("long cushion", BoxShape{Vec3(2.54, 0.05, 0.0365)},
                       Vec3(0, side * 0.66, 0.01825), "cloth");
        builder.object("short cushion", BoxShape{Vec3(0.05, 1.27, 0.0365)},
                       Vec3(side * 1.295, 0, 0.01825), "cloth");
        builder.object("long rail", BoxShape{Vec3(2.9, 0.13, 0.12)}, Vec3(0, side * 0.75, -0.018),
                       "wood");
        builder.object("short rail", BoxShape{Vec3(0.13, 1.36, 0.12)},
                       Vec3(side * 1.385, 0, -0.018), "wood");
    }
    builder.object("floor", PlaneShape{}, Vec3(0, 0, -0.8), "floor");
}

Table make_table(bool textured) {
    Table table;
    add_balls(table, textured);
    add_furniture(table.builder, textured);
    table.builder.lamp(Vec3(0.5, 0, 1.3), 0.6, 0.2, 20).bulb(Vec3(0.1, -0.5, 0.8), 0.04, 150);
    table.builder.environment(0.15);
    CameraState camera = test::camera(Vec3(0, 0.9, 0.34), Vec3(0.5, 0, 0.03), 0.45);
    camera.lens_radius = 0.008;
    table.frame = test::static_frame(camera);
    table.frame.scene_close = kShutter;
    return table;
}

void render_table(benchmark::State& state, bool textured, double clamp) {
    const Table table = make_table(textured);
    RenderSettings settings = test::small_settings(640, 360, static_cast<int>(state.range(0)));
    settings.clamp = clamp;
    const PreparedScene scene(table.builder.scene, settings);
    double rays = 0;
    for (auto _ : state) {
        const Film film = render_frame(scene, table.tracks, table.frame, settings);
        rays += static_cast<double>(film.statistics.camera_rays + film.statistics.scattered_rays +
                                    film.statistics.shadow_rays);
        if (!(test::mean_colour(film).x > 0)) {
            state.SkipWithError("the picture is black");
        }
    }
    state.counters["rays_per_cpu_second"] =
        benchmark::Counter(rays, benchmark::Counter::kIsRate | benchmark::Counter::kAvgThreads);
}

void BM_PlainTable(benchmark::State& state) {
    render_table(state, false, 0);
}
void BM_TexturedTable(benchmark::State& state) {
    render_table(state, true, 8);
}

void BM_PrepareTexturedTable(benchmark::State& state) {
    const Table table = make_table(true);
    const RenderSettings settings = test::small_settings(640, 360, 16);
    for (auto _ : state) {
        const PreparedScene scene(table.builder.scene, settings);
        benchmark::DoNotOptimize(&scene.data());
    }
}

/// A picture of 1024 x 1024 for both texture systems.
std::string lookup_picture() {
    const std::string path =
        (std::filesystem::temp_directory_path() / "carom_bench_lookup.tif").string();
    std::vector<std::uint8_t> values(3 * 1024 * 1024);
    for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] = static_cast<std::uint8_t>(i * 7 % 251);
    }
    const auto file = OIIO::ImageOutput::create(path);
    file->open(path, OIIO::ImageSpec(1024, 1024, 3, OIIO::TypeDesc::UINT8));
    file->write_image(OIIO::TypeDesc::UINT8, values.data());
    file->close();
    return path;
}

V2f place(std::uint32_t i) {
    return {static_cast<float>(i * 2654435761u >> 8) * 0x1p-24f,
            static_cast<float>(i * 805459861u >> 8) * 0x1p-24f};
}

void BM_PyramidLookup(benchmark::State& state) {
    const auto pyramid = load_image_pyramid(lookup_picture(), false);
    const ImageTables tables = pyramid->tables();
    std::uint32_t i = 0;
    for (auto _ : state) {
        const V2f uv = place(++i);
        benchmark::DoNotOptimize(
            scalar::look_up_image<scalar::One>(tables, {uv, V2f(0.004f, 0), V2f(0, 0.004f)}));
    }
}

void BM_TextureSystemLookup(benchmark::State& state) {
    const std::string path = lookup_picture();
    OIIO::TextureSystem* system = OIIO::TextureSystem::create(false);
    OIIO::TextureOpt options;
    options.swrap = options.twrap = OIIO::TextureOpt::WrapPeriodic;
    options.interpmode = OIIO::TextureOpt::InterpBilinear;
    options.mipmode = OIIO::TextureOpt::MipModeOneLevel;
    auto* handle = system->get_texture_handle(OIIO::ustring(path));
    auto* thread = system->get_perthread_info();
    std::uint32_t i = 0;
    for (auto _ : state) {
        const V2f uv = place(++i);
        float result[3] = {0, 0, 0};
        system->texture(handle, thread, options, uv.x, uv.y, 0.004f, 0, 0, 0.004f, 3, result);
        benchmark::DoNotOptimize(result);
    }
    OIIO::TextureSystem::destroy(system);
}

BENCHMARK(BM_PlainTable)->Arg(16)->Unit(benchmark::kSecond)->MeasureProcessCPUTime()->Iterations(1);
BENCHMARK(BM_TexturedTable)
    ->Arg(16)
    ->Unit(benchmark::kSecond)
    ->MeasureProcessCPUTime()
    ->Iterations(1);
BENCHMARK(BM_PrepareTexturedTable)->Unit(benchmark::kMillisecond)->Iterations(2);
BENCHMARK(BM_PyramidLookup);
BENCHMARK(BM_TextureSystemLookup);

}  // namespace
}  // namespace carom::render
