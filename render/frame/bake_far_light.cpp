#include "render/frame/bake_far_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <span>
#include <utility>

#include "core/colour.h"
#include "core/error.h"
#include "render/acceleration/flush_denormals.h"
#include "render/frame/far_cells.h"
#include "render/frame/far_panorama.h"
#include "render/frame/frame.h"
#include "render/frame/prepared_scene.h"
#include "render/integrator/path_integrator.h"
#include "render/integrator/workspace_pool.h"
#include "render/scene/still_scene.h"
#include "render/threads/thread_arena.h"

namespace carom::render {
namespace {

constexpr int kMaxBounces = 8;
constexpr std::uint64_t kSeed = 0x63617234;
constexpr float kAboveSurface = 5e-4F;  // m, where the rays to points begin
constexpr std::size_t kCellsAtOnce = 64;
constexpr std::size_t kPanoramaPixels = std::size_t{FarLight::kColumns} * FarLight::kColumns / 2;
/// Where cells are looked for first, above the middle of the region's box.
constexpr float kAboveBox = 0.3F;  // m

/// Without what moves, all of it near, and with a white material, the last one.
SceneDescription scene_to_bake(const SceneDescription& scene) {
    SceneDescription still = still_scene(scene);
    still.far.reset();
    MaterialDescription white;
    white.name = "white of the far light";
    white.surface.base = Vec3(1, 1, 1);
    still.materials.push_back(std::move(white));
    return still;
}

/// The scene at one time.
class StillScene {
  public:
    explicit StillScene(const SceneDescription& scene)
        : prepared_(scene, {}),
          frame_(prepared_.data().geometry, {}, 0, 0,
                 prepared_.data().cut_outs ? &*prepared_.data().cut_outs : nullptr),
          lights_(prepared_.data().lights.in_frame(frame_.motions())),
          transport_{frame_, prepared_.data().materials, lights_, prepared_.data().object_count} {}

    [[nodiscard]] const TransportScene& transport() const { return transport_; }
    [[nodiscard]] std::int32_t white() const {
        return static_cast<std::int32_t>(transport_.materials.size() - 1);
    }

  private:
    PreparedScene prepared_;
    FrameScene frame_;
    LightSet lights_;
    TransportScene transport_;
};

/// Traces the paths of cells.
class CellBaker {
  public:
    CellBaker(const StillScene& scene, int samples)
        : samples_(samples),
          integrator_(scene.transport(), settings(scene)),
          workspaces_(integrator_) {}

    /// Of some cells.
    void bake(std::span<const FarPoints> cells, std::span<V3f> irradiances) {
        const FlushDenormals flush;
        const WorkspacePool::Loan workspace(workspaces_);
        for (std::size_t cell = 0; cell < cells.size(); ++cell) {
            irradiances[cell] = irradiance(cells[cell], workspace.get());
        }
    }

  private:
    static PathSettings settings(const StillScene& scene) {
        PathSettings settings;
        settings.max_bounces = kMaxBounces;
        settings.split_vertices = 0;
        settings.glossy_samples = 1;
        settings.caustics = false;
        settings.white = scene.white();
        return settings;
    }

    [[nodiscard]] V3f irradiance(const FarPoints& cell, Integrator::Workspace* workspace) const {
        V3f sum(0);
        std::vector<RadianceSample> results(CameraBatch::kUsual);
        for (int first = 0; first < samples_; first += CameraBatch::kUsual) {
            CameraBatch batch;
            const int last = std::min(first + CameraBatch::kUsual, samples_);
            for (int sample = first; sample < last; ++sample) {
                add(cell, sample, batch);
            }
            RenderStatistics count;
            integrator_.samples(CameraRun::all(batch), 0, results.data(), workspace, count);
            for (int i = 0; i < batch.count; ++i) {
                sum += results[static_cast<std::size_t>(i)].radiance;
            }
        }
        return sum * (kPi / static_cast<float>(samples_));
    }

    static void add(const FarPoints& cell, int sample, CameraBatch& batch) {
        const FarPoint& point = cell.points[sample % cell.count];
        const auto low = static_cast<std::uint32_t>(cell.key);
        const auto high = static_cast<std::uint32_t>(cell.key >> 32);
        const auto index = static_cast<std::uint32_t>(sample);
        batch.add(SampleStream(kSeed, low, high, index), {0, 0, sample});
        const int at = batch.count - 1;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto i = static_cast<int>(axis);
            batch.origin[axis][at] = point.position[i] + kAboveSurface * point.normal[i];
            batch.direction[axis][at] = -point.normal[i];
        }
        batch.time[at] = 0;
    }

    int samples_;
    PathIntegrator integrator_;
    WorkspacePool workspaces_;
};

/// The irradiance of each cell.
std::vector<V3f> bake_cells(const StillScene& scene, const std::vector<FarPoints>& cells,
                            int samples, const WorkContext& context) {
    std::vector<V3f> irradiances(cells.size());
    CellBaker baker(scene, samples);
    std::mutex mutex;
    std::size_t done = 0;
    parallel_for((cells.size() + kCellsAtOnce - 1) / kCellsAtOnce, [&](std::size_t block) {
        if (context.stop.stop_requested()) {
            return;
        }
        const std::size_t first = block * kCellsAtOnce;
        const std::size_t count = std::min(kCellsAtOnce, cells.size() - first);
        baker.bake(std::span(cells).subspan(first, count),
                   std::span(irradiances).subspan(first, count));
        if (context.progress) {
            const std::lock_guard lock(mutex);
            done += count;
            context.progress(static_cast<double>(done) / static_cast<double>(cells.size()));
        }
    });
    if (context.stop.stop_requested()) {
        throw Stopped();
    }
    return irradiances;
}

/// A cell, and those around it in its face.
struct Neighbours {
    static constexpr int kMost = 27;
    int count = 0;
    std::array<V3f, kMost> light;
    std::array<float, kMost> weight{};  // less of those farther away
};

Neighbours neighbours_of(const std::vector<FarPoints>& cells, const std::vector<V3f>& irradiances,
                         std::uint64_t key) {
    Neighbours all;
    for (int k = 0; k < Neighbours::kMost; ++k) {
        const int step[3] = {k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1};
        const std::uint64_t other = FarGrid::neighbour(key, step[0], step[1], step[2]);
        const auto found = std::ranges::lower_bound(cells, other, {}, &FarPoints::key);
        if (found != cells.end() && found->key == other) {
            const int away = std::abs(step[0]) + std::abs(step[1]) + std::abs(step[2]);
            const auto at = static_cast<std::size_t>(all.count++);
            all.light[at] = irradiances[static_cast<std::size_t>(found - cells.begin())];
            all.weight[at] = 1 / static_cast<float>(1 << away);
        }
    }
    return all;
}

float median_brightness(const Neighbours& all) {
    std::array<float, Neighbours::kMost> brightness{};
    const auto count = static_cast<std::size_t>(all.count);
    std::transform(all.light.begin(), all.light.begin() + all.count, brightness.begin(),
                   [](const V3f& light) { return luminance(light); });
    std::sort(brightness.begin(), brightness.begin() + all.count);
    return (brightness[(count - 1) / 2] + brightness[count / 2]) / 2;
}

/// Takes noise away: the mean around each cell, less of what differs from the median there more
/// than noise does, such as the rare bright paths.
std::vector<FarLight::Cell> smoothed(const std::vector<FarPoints>& cells,
                                     const std::vector<V3f>& irradiances) {
    constexpr float kWidth = 0.12F;  // of a difference, over the sum
    constexpr float kDark = 1e-6F;
    std::vector<FarLight::Cell> result(cells.size());
    parallel_for(cells.size() / kCellsAtOnce + 1, [&](std::size_t block) {
        const std::size_t last = std::min((block + 1) * kCellsAtOnce, cells.size());
        for (std::size_t cell = block * kCellsAtOnce; cell < last; ++cell) {
            const Neighbours all = neighbours_of(cells, irradiances, cells[cell].key);
            const float middle = median_brightness(all);
            V3f sum(0);
            float weights = 0;
            for (std::size_t i = 0; i < static_cast<std::size_t>(all.count); ++i) {
                const float own = luminance(all.light[i]);
                const float difference = (own - middle) / (kWidth * (own + middle + kDark));
                const float weight = all.weight[i] / (1 + difference * difference);
                sum += weight * all.light[i];
                weights += weight;
            }
            result[cell] = {cells[cell].key, SharedExponent(sum / weights)};
        }
    });
    return result;
}

}  // namespace

std::shared_ptr<const FarLight> bake_far_light(const SceneDescription& scene,
                                               const WorkContext& context) {
    const FarRegion& region = *scene.far;
    const StillScene still(scene_to_bake(scene));
    const TransportScene& transport = still.transport();
    const V3f low(region.low), high(region.high);
    const V3f start((low.x + high.x) / 2, (low.y + high.y) / 2, high.z + kAboveBox);
    const std::vector<FarPoints> cells =
        find_far_cells(transport, FarGrid(region), start, far_numbers(transport), context);
    std::vector<FarLight::Cell> baked =
        smoothed(cells, bake_cells(still, cells, region.samples, context));
    const FarLight cells_alone(region, baked, std::vector<SharedExponent>(kPanoramaPixels));
    TransportScene with_light = transport;
    with_light.far = &cells_alone;
    return std::make_shared<const FarLight>(region, std::move(baked),
                                            far_panorama(with_light, region));
}

}  // namespace carom::render
