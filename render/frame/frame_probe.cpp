#include "render/frame/frame_probe.h"

#include <algorithm>
#include <map>
#include <utility>

#include "core/assert.h"
#include "core/cpu_time.h"
#include "core/error.h"
#include "render/acceleration/flush_denormals.h"
#include "render/frame/frame_work.h"
#include "render/frame/probe_blocks.h"
#include "render/frame/sample_plan.h"
#include "render/frame/tile_loop.h"

namespace carom::render {
namespace {

constexpr int kSide = TileRenderer::kTileSize;
static_assert(kSide == FrameProbe::kSmallestBlock);
constexpr std::size_t kTilePixels = std::size_t{kSide} * kSide;

}  // namespace

struct FrameProbe::Data {
    Data(const PreparedScene& scene, std::span<const sim::Track> tracks, const FrameInput& frame,
         const RenderSettings& settings, int block_size)
        : work(scene, tracks, frame, settings),
          blocks(settings.width, settings.height, block_size) {}

    void sample(std::size_t first, const SampleLimit& limit, const std::stop_token& stop);
    void trace_features(std::size_t first, const std::stop_token& stop);
    void sample_adaptively(const std::stop_token& stop);
    template <class Visit>
    void for_each_pixel_of_blocks(const Visit& visit) const;
    [[nodiscard]] SampleRound next_round(const WorkContext& context) const;
    [[nodiscard]] std::vector<Film> films(const std::vector<ProbeBlock>& shown, std::size_t first);
    void update_cost();
    [[nodiscard]] double reflection_seconds() const;
    [[nodiscard]] TileSums sums_of(std::size_t n) {
        return {&sums[n * kTilePixels], std::size_t{kSide}};
    }
    /// Of a pixel of the frame in the sums and features.
    [[nodiscard]] std::size_t place(std::size_t n, int x, int y) const {
        return n * kTilePixels + static_cast<std::size_t>(y - tiles[n].top) * kSide +
               static_cast<std::size_t>(x - tiles[n].left);
    }

    FrameWork work;
    ProbeBlocks blocks;
    std::vector<ProbeBlock> chosen;
    std::vector<ProbedTile> tiles;         // of these
    std::vector<PixelSums> sums;           // of these tiles, one below the other
    std::vector<TracedFeatures> features;  // the same, with adaptive sampling for the denoiser
    ProbeCost cost;
    double samples = 0;  // that the measured pixels need
    double preparation = 0;
    double planning_seconds = 0;  // CPU time of the rounds of all tiles, without their samples
};

/// Adds samples to the tiles from `first` on, until they have those of `limit`. Throws Stopped.
void FrameProbe::Data::sample(std::size_t first, const SampleLimit& limit,
                              const std::stop_token& stop) {
    RenderStatistics total;
    for_all_tiles(
        static_cast<int>(tiles.size() - first), {{}, stop}, total,
        [&](int i) {
            const std::size_t n = first + static_cast<std::size_t>(i);
            const double begin = thread_cpu_seconds();
            const RenderStatistics count =
                work.tiles().add_samples(tiles[n].index, sums_of(n), limit, stop);
            tiles[n].seconds += thread_cpu_seconds() - begin;
            tiles[n].taken += static_cast<double>(count.camera_rays);
            return count;
        },
        [](int) {});
}

/// Takes the first camera rays of the tiles from `first` on, if it is for the denoiser. Throws
/// Stopped.
void FrameProbe::Data::trace_features(std::size_t first, const std::stop_token& stop) {
    if (!work.settings().for_denoiser) {
        return;
    }
    features.resize(sums.size());
    RenderStatistics none;
    for_all_tiles(
        static_cast<int>(tiles.size() - first), {{}, stop}, none,
        [&](int i) {
            const std::size_t n = first + static_cast<std::size_t>(i);
            const double begin = thread_cpu_seconds();
            for (const FeaturePixel& pixel :
                 work.tiles().trace_features(tiles[n].index, sums_of(n))) {
                features[place(n, pixel.x, pixel.y)] = pixel.traced;
            }
            tiles[n].fixed_seconds += thread_cpu_seconds() - begin;
            return RenderStatistics{};
        },
        [](int) {});
}

/// Calls visit(x, y, n, pixel) for each place of a picture of all blocks, one below the other: the
/// pixel of the frame that it shows, and its tile. Beyond the frame's edge that is the pixel at the
/// edge.
template <class Visit>
void FrameProbe::Data::for_each_pixel_of_blocks(const Visit& visit) const {
    std::map<int, std::size_t> tile_at;
    for (std::size_t n = 0; n < tiles.size(); ++n) {
        tile_at[tiles[n].top * work.settings().width + tiles[n].left] = n;
    }
    const int size = blocks.size();
    for (int y = 0; y < size * static_cast<int>(chosen.size()); ++y) {
        const ProbeBlock& block = chosen[static_cast<std::size_t>(y / size)];
        for (int x = 0; x < size; ++x) {
            const int u = std::min(block.x * size + x, work.settings().width - 1);
            const int v = std::min(block.y * size + y % size, work.settings().height - 1);
            const std::size_t n =
                tile_at.at(v / kSide * kSide * work.settings().width + u / kSide * kSide);
            visit(x, y, n, place(n, u, v));
        }
    }
}

/// As FrameWork::next_round, as if all blocks were the whole frame.
SampleRound FrameProbe::Data::next_round(const WorkContext& context) const {
    const int width = blocks.size();
    const int height = width * static_cast<int>(chosen.size());
    std::vector<V3f> means, differences;
    DenoiserPlanes planes =
        work.settings().for_denoiser ? DenoiserPlanes(width, height) : DenoiserPlanes();
    std::vector<int> plan;
    for_each_pixel_of_blocks([&](int x, int y, std::size_t, std::size_t pixel) {
        const PixelSums& own = sums[pixel];
        const V3f half[2] = {own.mean_of_half(0), own.mean_of_half(1)};
        means.push_back(0.5F * (half[0] + half[1]));
        differences.push_back(0.5F * (half[0] - half[1]));
        plan.push_back(own.samples);
        if (!planes.empty()) {
            const FeaturePixel one{
                x, y, {features_of_half(own, 0), features_of_half(own, 1)}, features[pixel]};
            planes.write({&one, 1}, 1, &own, 1);
        }
    });
    MeasuredError error = error_of_halves(means, differences, width, height);
    if (!planes.empty()) {
        Film film;
        film.width = width;
        film.height = height;
        for (const V3f& mean : means) {
            film.rgba.insert(film.rgba.end(), {mean.x, mean.y, mean.z, 1});
        }
        planes.append_to(film);
        error = measured_error(error_after_denoising(film, context));
    }
    return render::next_round(plan, error, work.settings());
}

/// Takes the rounds of all tiles. A plan depends on all of them, so that later ones can change how
/// many samples the earlier ones get. Throws Stopped.
void FrameProbe::Data::sample_adaptively(const std::stop_token& stop) {
    std::vector<int> plan(work.pixel_count(), work.settings().samples);
    planning_seconds = 0;
    for (;;) {
        const double begin = process_cpu_seconds();
        const SampleRound round = next_round({{}, stop});
        planning_seconds += process_cpu_seconds() - begin;
        for (ProbedTile& tile : tiles) {
            tile.wanted = 0;
        }
        auto planned = round.plan.begin();
        std::vector<bool> is_counted(sums.size());
        for_each_pixel_of_blocks([&](int, int, std::size_t n, std::size_t pixel) {
            const int own = *planned++;
            if (!is_counted[pixel]) {
                is_counted[pixel] = true;
                tiles[n].wanted += own;
                const auto in_tile = static_cast<int>(pixel % kTilePixels);
                plan[work.index(tiles[n].left + in_tile % kSide, tiles[n].top + in_tile / kSide)] =
                    own;
            }
        });
        if (!round.is_needed) {
            return;
        }
        sample(0, SampleLimit::planned(plan), stop);
    }
}

/// The pictures of the blocks whose finished tiles begin with `first`.
std::vector<Film> FrameProbe::Data::films(const std::vector<ProbeBlock>& shown, std::size_t first) {
    AovPlanes planes = work.make_aovs(work.settings().aovs);
    DenoiserPlanes denoiser = work.make_denoiser_planes();
    Film whole = work.empty_film();
    std::vector<TracedFeatures> traced(features.empty() ? 0 : work.pixel_count());
    for (std::size_t n = first; n < tiles.size(); ++n) {
        const double begin = thread_cpu_seconds();
        const TileSums tile = sums_of(n);
        for (int i = 0; i < (traced.empty() ? 0 : tiles[n].width * tiles[n].height); ++i) {
            const int x = tiles[n].left + i % tiles[n].width;
            const int y = tiles[n].top + i / tiles[n].width;
            traced[work.index(x, y)] = features[place(n, x, y)];
        }
        work.tiles().write(tiles[n].index, tile, whole);
        work.tiles().write(tiles[n].index, tile, planes);
        work.tiles().write(tiles[n].index, tile, denoiser, traced);
        tiles[n].fixed_seconds += thread_cpu_seconds() - begin;
    }
    whole.aovs = planes.take();
    denoiser.append_to(whole);
    std::vector<Film> films;
    films.reserve(shown.size());
    for (const ProbeBlock& block : shown) {
        films.push_back(cut_block(whole, block, blocks.size()));
    }
    return films;
}

/// A tile that was stopped early, or planned anew, costs in proportion to its samples.
void FrameProbe::Data::update_cost() {
    std::vector<ProbeCost> by_block(chosen.size());
    samples = 0;
    for (const ProbedTile& tile : tiles) {
        if (tile.taken > 0) {  // it was not stopped before it began
            by_block[tile.block].seconds +=
                tile.seconds * tile.wanted / tile.taken + tile.fixed_seconds;
            by_block[tile.block].pixels += tile.pixels();
            samples += tile.wanted;
        }
    }
    cost = {};
    for (const ProbeCost& block : by_block) {
        if (block.pixels > 0) {
            cost.seconds += block.seconds;
            cost.pixels += block.pixels;
            cost.per_pixel.push_back(block.seconds / block.pixels);
        }
    }
    cost.seconds += planning_seconds;
}

double FrameProbe::Data::reflection_seconds() const {
    constexpr std::size_t kMeasured = 8;
    const std::size_t number = work.tiles().reflection_count();
    const std::size_t measured = std::min(number, kMeasured);
    if (measured == 0) {
        return 0;
    }
    const double begin = thread_cpu_seconds();
    RenderStatistics none;
    for (std::size_t i = 0; i < measured; ++i) {
        (void)work.tiles().reflection(i * number / measured, samples / cost.pixels, 0, none);
    }
    return (thread_cpu_seconds() - begin) * static_cast<double>(number) /
           static_cast<double>(measured);
}

FrameProbe::FrameProbe(const PreparedScene& scene, std::span<const sim::Track> tracks,
                       const FrameInput& frame, const RenderSettings& settings, int block_size) {
    CAROM_ASSERT(block_size > 0 && block_size % kSmallestBlock == 0);
    const FlushDenormals flush;  // while Embree builds
    const double begin = process_cpu_seconds();
    data_ = std::make_unique<Data>(scene, tracks, frame, settings, block_size);
    data_->preparation = process_cpu_seconds() - begin;
}

FrameProbe::~FrameProbe() = default;
FrameProbe::FrameProbe(FrameProbe&&) noexcept = default;
FrameProbe& FrameProbe::operator=(FrameProbe&&) noexcept = default;

std::vector<Film> FrameProbe::render_blocks(int count, const WorkContext& context) {
    Data& data = *data_;
    const TileRenderer& renderer = data.work.tiles();
    const std::size_t first = data.tiles.size();
    const std::vector<ProbeBlock> next = data.blocks.next(count);
    for (const ProbeBlock& block : next) {
        data.blocks.add_tiles(block, data.chosen.size(), data.tiles);
        data.chosen.push_back(block);
    }
    data.sums.resize(data.tiles.size() * kTilePixels);
    for (std::size_t n = first; n < data.tiles.size(); ++n) {
        data.tiles[n].wanted = renderer.samples() * data.tiles[n].pixels();
    }
    std::vector<Film> films;
    try {
        data.sample(first, {renderer.samples()}, context.stop);
        if (renderer.is_adaptive() && !next.empty()) {
            data.trace_features(first, context.stop);
            data.sample_adaptively(context.stop);
        }
        films = data.films(next, first);
    } catch (const Stopped&) {  // what was rendered by then counts
    }
    data.update_cost();
    return films;
}

int FrameProbe::blocks_left() const {
    return data_->blocks.left();
}

const ProbeCost& FrameProbe::cost() const {
    return data_->cost;
}

double FrameProbe::frame_seconds() const {
    const ProbeCost& cost = data_->cost;
    CAROM_ASSERT(cost.pixels > 0);
    return data_->preparation + data_->reflection_seconds() +
           cost.seconds / cost.pixels * static_cast<double>(data_->work.pixel_count());
}

double FrameProbe::preparation_seconds() const {
    return data_->preparation;
}

}  // namespace carom::render
