#include "render/frame/frame_probe.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "core/assert.h"
#include "core/cpu_time.h"
#include "core/error.h"
#include "render/acceleration/flush_denormals.h"
#include "render/frame/frame_work.h"
#include "render/frame/sample_plan.h"
#include "render/frame/tile_loop.h"

namespace carom::render {
namespace {

constexpr int kSide = TileRenderer::kTileSize;
constexpr std::size_t kTilePixels = std::size_t{kSide} * kSide;
constexpr int kTilesAcross = FrameProbe::kBlockSize / kSide;  // of a block

/// A block, counted in blocks from the top left.
struct Block {
    int x = 0;
    int y = 0;
};

/// A tile of a block. Tiles stand one below the other in the sums of a call.
struct ProbedTile {
    int x = 0;  // counted in tiles from the top left of the frame
    int y = 0;
    std::size_t block = 0;  // of the call
    double seconds = 0;     // spent so far
    double wanted = 0;      // samples that its pixels need
    double taken = 0;       // of these
};

int divided_up(int value, int by) {
    return (value + by - 1) / by;
}

/// Point n of an additive sequence that fills the unit square evenly (Roberts 2018, "The
/// unreasonable effectiveness of quasirandom sequences"; 1.3247... is the plastic number).
std::array<double, 2> even_point(int n) {
    constexpr double kPlastic = 1.32471795724474602596;
    const auto part = [n](double step) {
        const double value = 0.5 + step * n;
        return value - std::floor(value);
    };
    return {part(1 / kPlastic), part(1 / (kPlastic * kPlastic))};
}

/// The pixels of a block; beyond the frame's edge those at the edge.
Film cut_block(const Film& whole, const Block& block) {
    constexpr int kBlock = FrameProbe::kBlockSize;
    Film film;
    film.width = kBlock;
    film.height = kBlock;
    for (const Channel& channel : whole.aovs) {
        film.aovs.push_back({channel.name, {}});
    }
    for (int i = 0; i < kBlock * kBlock; ++i) {
        const int x = std::min(block.x * kBlock + i % kBlock, whole.width - 1);
        const int y = std::min(block.y * kBlock + i / kBlock, whole.height - 1);
        const auto pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(whole.width) +
                           static_cast<std::size_t>(x);
        const float* rgba = &whole.rgba[4 * pixel];
        film.rgba.insert(film.rgba.end(), rgba, rgba + 4);
        for (std::size_t c = 0; c < film.aovs.size(); ++c) {
            film.aovs[c].values.push_back(whole.aovs[c].values[pixel]);
        }
    }
    return film;
}

}  // namespace

struct FrameProbe::Data {
    Data(const PreparedScene& scene, std::span<const sim::Track> tracks, const FrameInput& frame,
         const RenderSettings& settings)
        : work(scene, tracks, frame, settings),
          columns(divided_up(settings.width, kBlockSize)),
          rows(divided_up(settings.height, kBlockSize)) {}

    [[nodiscard]] const RenderSettings& settings() const { return work.settings(); }
    [[nodiscard]] int width_of(const ProbedTile& tile) const {
        return std::min(kSide, settings().width - tile.x * kSide);
    }
    [[nodiscard]] int height_of(const ProbedTile& tile) const {
        return std::min(kSide, settings().height - tile.y * kSide);
    }
    [[nodiscard]] int pixels_of(const ProbedTile& tile) const {
        return width_of(tile) * height_of(tile);
    }
    [[nodiscard]] int index_of(const ProbedTile& tile) const {
        return tile.y * divided_up(settings().width, kSide) + tile.x;
    }

    [[nodiscard]] std::vector<Block> next_blocks(int count);
    [[nodiscard]] std::vector<ProbedTile> tiles_of(const std::vector<Block>& blocks) const;
    [[nodiscard]] bool sample(std::vector<ProbedTile>& tiles, std::vector<PixelSums>& sums,
                              const SampleLimit& limit, const WorkContext& context) const;
    void fill_beyond_edge(const std::vector<ProbedTile>& tiles, std::vector<PixelSums>& sums) const;
    [[nodiscard]] std::vector<int> plan(std::vector<ProbedTile>& tiles,
                                        std::vector<PixelSums>& sums) const;
    [[nodiscard]] std::vector<Film> films(const std::vector<Block>& blocks,
                                          std::vector<ProbedTile>& tiles,
                                          std::vector<PixelSums>& sums) const;
    void add_cost(const std::vector<ProbedTile>& tiles, std::size_t blocks);
    [[nodiscard]] double reflection_seconds() const;

    FrameWork work;
    int columns;  // of blocks
    int rows;
    int next = 0;  // point of the sequence
    std::set<std::pair<int, int>> used;
    ProbeCost cost;
    double samples = 0;  // of all measured pixels
    double preparation = 0;
};

std::vector<Block> FrameProbe::Data::next_blocks(int count) {
    std::vector<Block> blocks;
    while (std::ssize(blocks) < count && std::ssize(used) < std::ptrdiff_t{columns} * rows) {
        const auto [u, v] = even_point(next++);
        Block block{static_cast<int>(u * columns), static_cast<int>(v * rows)};
        while (!used.emplace(block.x, block.y).second) {  // the next one in reading order
            block.x = (block.x + 1) % columns;
            block.y = block.x == 0 ? (block.y + 1) % rows : block.y;
        }
        blocks.push_back(block);
    }
    return blocks;
}

std::vector<ProbedTile> FrameProbe::Data::tiles_of(const std::vector<Block>& blocks) const {
    std::vector<ProbedTile> tiles;
    for (std::size_t block = 0; block < blocks.size(); ++block) {
        for (int i = 0; i < kTilesAcross * kTilesAcross; ++i) {
            const ProbedTile tile{blocks[block].x * kTilesAcross + i % kTilesAcross,
                                  blocks[block].y * kTilesAcross + i / kTilesAcross, block};
            if (width_of(tile) > 0 && height_of(tile) > 0) {
                tiles.push_back(tile);
            }
        }
    }
    return tiles;
}

/// Returns whether all tiles have the samples of `limit`.
bool FrameProbe::Data::sample(std::vector<ProbedTile>& tiles, std::vector<PixelSums>& sums,
                              const SampleLimit& limit, const WorkContext& context) const {
    RenderStatistics total;
    try {
        for_all_tiles(
            static_cast<int>(tiles.size()), {{}, context.stop}, total,
            [&](int i) {
                const auto n = static_cast<std::size_t>(i);
                const double begin = thread_cpu_seconds();
                const RenderStatistics count = work.tiles().add_samples(
                    index_of(tiles[n]), {&sums[n * kTilePixels], std::size_t{kSide}}, limit,
                    context.stop);
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
void FrameProbe::Data::fill_beyond_edge(const std::vector<ProbedTile>& tiles,
                                        std::vector<PixelSums>& sums) const {
    for (std::size_t n = 0; n < tiles.size(); ++n) {
        PixelSums* first = &sums[n * kTilePixels];
        for (int i = 0; i < kSide * kSide; ++i) {
            const int x = std::min(i % kSide, width_of(tiles[n]) - 1);
            const int y = std::min(i / kSide, height_of(tiles[n]) - 1);
            if (y * kSide + x != i) {
                first[i] = first[y * kSide + x];
            }
        }
    }
}

/// The samples of the tiles' pixels, planned as if they were the whole frame; by the frame's pixel.
std::vector<int> FrameProbe::Data::plan(std::vector<ProbedTile>& tiles,
                                        std::vector<PixelSums>& sums) const {
    fill_beyond_edge(tiles, sums);
    RenderSettings stacked = settings();
    stacked.width = kSide;
    stacked.height = static_cast<int>(tiles.size()) * kSide;
    const std::vector<int> planned = plan_samples(sums, stacked);
    std::vector<int> plan(work.pixel_count(), settings().samples);
    for (std::size_t n = 0; n < tiles.size(); ++n) {
        tiles[n].wanted = 0;
        for (int y = 0; y < height_of(tiles[n]); ++y) {
            for (int x = 0; x < width_of(tiles[n]); ++x) {
                const int count = planned[n * kTilePixels + static_cast<std::size_t>(y) * kSide +
                                          static_cast<std::size_t>(x)];
                plan[static_cast<std::size_t>(tiles[n].y * kSide + y) *
                         static_cast<std::size_t>(settings().width) +
                     static_cast<std::size_t>(tiles[n].x * kSide + x)] = count;
                tiles[n].wanted += count;
            }
        }
    }
    return plan;
}

/// The pictures of the blocks from their finished tiles.
std::vector<Film> FrameProbe::Data::films(const std::vector<Block>& blocks,
                                          std::vector<ProbedTile>& tiles,
                                          std::vector<PixelSums>& sums) const {
    AovPlanes planes = work.make_aovs(settings().aovs);
    Film whole = work.empty_film();
    for (std::size_t n = 0; n < tiles.size(); ++n) {
        const double begin = thread_cpu_seconds();
        const TileSums tile{&sums[n * kTilePixels], std::size_t{kSide}};
        work.tiles().write(index_of(tiles[n]), tile, whole);
        work.tiles().write(index_of(tiles[n]), tile, planes);
        tiles[n].seconds += thread_cpu_seconds() - begin;
    }
    whole.aovs = planes.take();
    std::vector<Film> films;
    films.reserve(blocks.size());
    for (const Block& block : blocks) {
        films.push_back(cut_block(whole, block));
    }
    return films;
}

void FrameProbe::Data::add_cost(const std::vector<ProbedTile>& tiles, std::size_t blocks) {
    std::vector<double> seconds(blocks);
    std::vector<double> pixels(blocks);
    for (const ProbedTile& tile : tiles) {
        if (tile.taken == 0) {
            continue;  // stopped before it began
        }
        seconds[tile.block] += tile.seconds * std::max(1.0, tile.wanted / tile.taken);
        pixels[tile.block] += pixels_of(tile);
        samples += tile.wanted;
    }
    for (std::size_t block = 0; block < blocks; ++block) {
        if (pixels[block] > 0) {
            cost.seconds += seconds[block];
            cost.pixels += pixels[block];
            cost.per_pixel.push_back(seconds[block] / pixels[block]);
        }
    }
}

double FrameProbe::Data::reflection_seconds() const {
    constexpr std::size_t kMeasured = 8;
    const std::size_t number = work.tiles().reflection_count();
    const std::size_t measured = std::min(number, kMeasured);
    if (measured == 0 || cost.pixels == 0) {
        return 0;
    }
    const double begin = thread_cpu_seconds();
    RenderStatistics none;
    for (std::size_t i = 0; i < measured; ++i) {
        (void)work.tiles().reflection(i * number / measured, samples / cost.pixels, none);
    }
    return (thread_cpu_seconds() - begin) * static_cast<double>(number) /
           static_cast<double>(measured);
}

FrameProbe::FrameProbe(const PreparedScene& scene, std::span<const sim::Track> tracks,
                       const FrameInput& frame, const RenderSettings& settings) {
    const FlushDenormals flush;  // while Embree builds
    const double begin = process_cpu_seconds();
    data_ = std::make_unique<Data>(scene, tracks, frame, settings);
    data_->preparation = process_cpu_seconds() - begin;
}

FrameProbe::~FrameProbe() = default;
FrameProbe::FrameProbe(FrameProbe&&) noexcept = default;
FrameProbe& FrameProbe::operator=(FrameProbe&&) noexcept = default;

std::vector<Film> FrameProbe::render_blocks(int count, const WorkContext& context) {
    const TileRenderer& renderer = data_->work.tiles();
    const std::vector<Block> blocks = data_->next_blocks(count);
    std::vector<ProbedTile> tiles = data_->tiles_of(blocks);
    std::vector<PixelSums> sums(tiles.size() * kTilePixels);
    for (ProbedTile& tile : tiles) {
        tile.wanted = static_cast<double>(renderer.samples()) * data_->pixels_of(tile);
    }
    bool is_complete = data_->sample(tiles, sums, {renderer.samples()}, context);
    if (is_complete && renderer.is_adaptive() && !tiles.empty()) {
        const std::vector<int> plan = data_->plan(tiles, sums);
        is_complete = data_->sample(tiles, sums, SampleLimit::planned(plan), context);
    }
    std::vector<Film> films;
    if (is_complete) {
        films = data_->films(blocks, tiles, sums);
    }
    data_->add_cost(tiles, blocks.size());
    return films;
}

int FrameProbe::blocks_left() const {
    return data_->columns * data_->rows - static_cast<int>(data_->used.size());
}

const ProbeCost& FrameProbe::cost() const {
    return data_->cost;
}

double FrameProbe::frame_seconds() const {
    CAROM_ASSERT(data_->cost.pixels > 0);
    return data_->preparation + data_->reflection_seconds() +
           data_->cost.seconds / data_->cost.pixels *
               static_cast<double>(data_->work.pixel_count());
}

double FrameProbe::preparation_seconds() const {
    return data_->preparation;
}

}  // namespace carom::render
