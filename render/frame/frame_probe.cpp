#include "render/frame/frame_probe.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#include "core/assert.h"
#include "core/cpu_time.h"
#include "core/error.h"
#include "render/acceleration/flush_denormals.h"
#include "render/frame/frame_session.h"
#include "render/frame/probe_blocks.h"

namespace carom::render {

static_assert(TileRenderer::kTileSize == FrameProbe::kSmallestBlock);

struct FrameProbe::Data final : SessionObserver {
    Data(const PreparedScene& scene, std::span<const sim::Track> tracks, const FrameInput& frame,
         const RenderSettings& settings, int block_size)
        : session(scene, tracks, frame, settings, SumsKind::needed_by(settings), sums),
          blocks(settings.width, settings.height, block_size) {}

    /// Different tiles may be reported at the same time; the map stays as it is.
    void sampled(int tile, const RenderStatistics& count, double seconds) override {
        ProbedTile& probed = tiles.at(tile);
        probed.seconds += seconds;
        probed.taken += static_cast<double>(count.camera_rays);
    }
    void traced(int tile, double seconds) override { tiles.at(tile).fixed_seconds += seconds; }
    void planned(double seconds) override { planning_seconds += seconds; }

    void add(const std::vector<ProbeBlock>& next);
    [[nodiscard]] std::vector<Film> films(const std::vector<ProbeBlock>& shown,
                                          const WorkContext& context);
    void update_cost();
    [[nodiscard]] double reflection_seconds() const;

    FrameSums::Data sums;
    FrameSession session;
    ProbeBlocks blocks;
    std::vector<ProbeBlock> chosen;
    std::map<int, ProbedTile> tiles;  // of these, by their indices
    ProbeCost cost;
    double samples = 0;  // that the measured pixels need
    double preparation = 0;
    double planning_seconds = 0;  // CPU time of the rounds of all tiles, without their samples
};

/// The session's picture is all blocks, one below the other, so that they stand for the frame when
/// samples are planned. Beyond the frame's edge it shows the pixels at the edge.
void FrameProbe::Data::add(const std::vector<ProbeBlock>& next) {
    for (const ProbeBlock& block : next) {
        std::vector<ProbedTile> own;
        blocks.add_tiles(block, chosen.size(), own);
        for (const ProbedTile& tile : own) {
            tiles.emplace(tile.index, tile);
        }
        chosen.push_back(block);
    }
    FramePart part;
    for (const auto& [index, tile] : tiles) {
        part.tiles.push_back(index);
    }
    const int size = blocks.size();
    part.width = size;
    part.height = size * static_cast<int>(chosen.size());
    part.pixel = [this, size](int x, int y) {
        const ProbeBlock& block = chosen[static_cast<std::size_t>(y / size)];
        const RenderSettings& settings = session.settings();
        return std::pair(std::min(block.x * size + x, settings.width - 1),
                         std::min(block.y * size + y % size, settings.height - 1));
    };
    session.restrict_to(std::move(part));
}

/// The pictures of these blocks.
std::vector<Film> FrameProbe::Data::films(const std::vector<ProbeBlock>& shown,
                                          const WorkContext& context) {
    FramePlanes planes =
        session.make_planes(session.settings().aovs, session.settings().for_denoiser);
    planes.make_room(session.pixel_count());
    for (auto& [index, tile] : tiles) {
        const bool is_shown = tile.block + shown.size() >= chosen.size();
        if (is_shown && !context.stop.stop_requested()) {
            const double begin = thread_cpu_seconds();
            session.write(index, planes);
            tile.fixed_seconds += thread_cpu_seconds() - begin;
        }
    }
    Film whole = std::move(planes.film);
    whole.aovs = planes.aovs.take();
    whole.half_aovs = planes.denoiser.take();
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
    for (const auto& [index, tile] : tiles) {
        if (tile.taken <= 0) {  // it was stopped before it began
            continue;
        }
        const std::vector<int>& planned = sums.tiles[static_cast<std::size_t>(index)].planned;
        const double wanted = planned.empty()
                                  ? session.tiles().samples() * tile.pixels()
                                  : std::accumulate(planned.begin(), planned.end(), 0.0);
        by_block[tile.block].seconds += tile.seconds * wanted / tile.taken + tile.fixed_seconds;
        by_block[tile.block].pixels += tile.pixels();
        samples += wanted;
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
    const std::size_t number = session.tiles().reflection_count();
    const std::size_t measured = std::min(number, kMeasured);
    if (measured == 0) {
        return 0;
    }
    const double begin = thread_cpu_seconds();
    RenderStatistics none;
    for (std::size_t i = 0; i < measured; ++i) {
        (void)session.tiles().reflection(i * number / measured, samples / cost.pixels, 0, none);
    }
    return (thread_cpu_seconds() - begin) * static_cast<double>(number) /
           static_cast<double>(measured);
}

FrameProbe::FrameProbe(const PreparedScene& scene, std::span<const sim::Track> tracks,
                       const FrameInput& frame, const RenderSettings& settings, int block_size) {
    CAROM_ASSERT(block_size > 0 && block_size % kSmallestBlock == 0);
    const FlushDenormals flush;
    const double begin = process_cpu_seconds();
    data_ = std::make_unique<Data>(scene, tracks, frame, settings, block_size);
    data_->preparation = process_cpu_seconds() - begin;
}

FrameProbe::~FrameProbe() = default;
FrameProbe::FrameProbe(FrameProbe&&) noexcept = default;
FrameProbe& FrameProbe::operator=(FrameProbe&&) noexcept = default;

std::vector<Film> FrameProbe::render_blocks(int count, const WorkContext& context) {
    Data& data = *data_;
    const std::vector<ProbeBlock> next = data.blocks.next(count);
    data.add(next);
    std::vector<Film> films;
    try {
        if (!next.empty()) {
            data.planning_seconds = 0;
            data.session.refine(std::numeric_limits<int>::max(), {{}, context.stop}, data);
        }
        films = data.films(next, context);
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
           cost.seconds / cost.pixels * static_cast<double>(data_->session.pixel_count());
}

double FrameProbe::preparation_seconds() const {
    return data_->preparation;
}

}  // namespace carom::render
