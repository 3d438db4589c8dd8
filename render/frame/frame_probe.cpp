#include "render/frame/frame_probe.h"

#include <algorithm>

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

    [[nodiscard]] bool sample(std::size_t first, const SampleLimit& limit,
                              const std::stop_token& stop);
    void fill_beyond_edge(std::size_t first);
    [[nodiscard]] std::vector<int> plan();
    [[nodiscard]] std::vector<Film> films(const std::vector<ProbeBlock>& chosen, std::size_t first);
    void update_cost();
    [[nodiscard]] double reflection_seconds() const;

    FrameWork work;
    ProbeBlocks blocks;
    std::size_t block_count = 0;    // that were chosen
    std::vector<ProbedTile> tiles;  // of these
    std::vector<PixelSums> sums;    // of these tiles, one below the other
    ProbeCost cost;
    double samples = 0;  // that the measured pixels need
    double preparation = 0;
};

/// Adds samples to the tiles from `first` on. Returns whether they have those of `limit`.
bool FrameProbe::Data::sample(std::size_t first, const SampleLimit& limit,
                              const std::stop_token& stop) {
    RenderStatistics total;
    try {
        for_all_tiles(
            static_cast<int>(tiles.size() - first), {{}, stop}, total,
            [&](int i) {
                const std::size_t n = first + static_cast<std::size_t>(i);
                const double begin = thread_cpu_seconds();
                const RenderStatistics count = work.tiles().add_samples(
                    tiles[n].index, {&sums[n * kTilePixels], std::size_t{kSide}}, limit, stop);
                tiles[n].seconds += thread_cpu_seconds() - begin;
                tiles[n].taken += static_cast<double>(count.camera_rays);
                return count;
            },
            [](int) {});
    } catch (const Stopped&) {
        return false;
    }
    return true;
}

/// Pixels of a tile beyond the edge of the frame get the sums of the nearest pixel.
void FrameProbe::Data::fill_beyond_edge(std::size_t first) {
    for (std::size_t n = first; n < tiles.size(); ++n) {
        PixelSums* pixels = &sums[n * kTilePixels];
        for (int i = 0; i < kSide * kSide; ++i) {
            const int x = std::min(i % kSide, tiles[n].width - 1);
            const int y = std::min(i / kSide, tiles[n].height - 1);
            if (y * kSide + x != i) {
                pixels[i] = pixels[y * kSide + x];
            }
        }
    }
}

/// The samples of the tiles' pixels, planned as if all tiles were the whole frame; by the frame's
/// pixel. The plan depends only on the first samples, so later ones do not change it.
std::vector<int> FrameProbe::Data::plan() {
    RenderSettings stacked = work.settings();
    stacked.width = kSide;
    stacked.height = static_cast<int>(tiles.size()) * kSide;
    const std::vector<int> planned = plan_samples(sums, stacked);
    std::vector<int> plan(work.pixel_count(), stacked.samples);
    for (std::size_t n = 0; n < tiles.size(); ++n) {
        tiles[n].wanted = 0;
        for (int y = 0; y < tiles[n].height; ++y) {
            const std::size_t from = n * kTilePixels + static_cast<std::size_t>(y) * kSide;
            const auto to = static_cast<std::size_t>(tiles[n].top + y) *
                                static_cast<std::size_t>(work.settings().width) +
                            static_cast<std::size_t>(tiles[n].left);
            for (std::size_t x = 0; x < static_cast<std::size_t>(tiles[n].width); ++x) {
                plan[to + x] = planned[from + x];
                tiles[n].wanted += planned[from + x];
            }
        }
    }
    return plan;
}

/// The pictures of the blocks whose finished tiles begin with `first`.
std::vector<Film> FrameProbe::Data::films(const std::vector<ProbeBlock>& chosen,
                                          std::size_t first) {
    AovPlanes planes = work.make_aovs(work.settings().aovs);
    DenoiserPlanes denoiser = work.make_denoiser_planes();
    Film whole = work.empty_film();
    for (std::size_t n = first; n < tiles.size(); ++n) {
        const double begin = thread_cpu_seconds();
        const TileSums tile{&sums[n * kTilePixels], std::size_t{kSide}};
        work.tiles().write(tiles[n].index, tile, whole);
        work.tiles().write(tiles[n].index, tile, planes);
        work.tiles().write(tiles[n].index, tile, denoiser);
        tiles[n].seconds += thread_cpu_seconds() - begin;
    }
    whole.aovs = planes.take();
    denoiser.append_to(whole);
    std::vector<Film> films;
    films.reserve(chosen.size());
    for (const ProbeBlock& block : chosen) {
        films.push_back(cut_block(whole, block, blocks.size()));
    }
    return films;
}

/// A tile that was stopped early, or planned anew, costs in proportion to its samples.
void FrameProbe::Data::update_cost() {
    std::vector<ProbeCost> by_block(block_count);
    samples = 0;
    for (const ProbedTile& tile : tiles) {
        if (tile.taken > 0) {  // it was not stopped before it began
            by_block[tile.block].seconds += tile.seconds * tile.wanted / tile.taken;
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
    const std::vector<ProbeBlock> chosen = data.blocks.next(count);
    for (const ProbeBlock& block : chosen) {
        data.blocks.add_tiles(block, data.block_count++, data.tiles);
    }
    data.sums.resize(data.tiles.size() * kTilePixels);
    for (std::size_t n = first; n < data.tiles.size(); ++n) {
        data.tiles[n].wanted = renderer.samples() * data.tiles[n].pixels();
    }
    bool is_complete = !chosen.empty() && data.sample(first, {renderer.samples()}, context.stop);
    if (is_complete && renderer.is_adaptive()) {
        data.fill_beyond_edge(first);
        const std::vector<int> plan = data.plan();
        is_complete = data.sample(first, SampleLimit::planned(plan), context.stop);
    }
    std::vector<Film> films = is_complete ? data.films(chosen, first) : std::vector<Film>();
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
