#include "render/frame/probe_blocks.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/frame/tile_renderer.h"

namespace carom::render {
namespace {

constexpr int kSide = TileRenderer::kTileSize;

int divided_up(int value, int by) {
    return (value + by - 1) / by;
}

/// Point n of an additive sequence that fills the unit square evenly (Roberts 2018, "The
/// unreasonable effectiveness of quasirandom sequences"). Its steps are powers of the plastic
/// number, the real root of x^3 = x + 1.
std::array<double, 2> even_point(int n) {
    constexpr double kPlastic = 1.32471795724474602596;
    const auto part = [n](double step) {
        const double value = 0.5 + step * n;
        return value - std::floor(value);
    };
    return {part(1 / kPlastic), part(1 / (kPlastic * kPlastic))};
}

}  // namespace

ProbeBlocks::ProbeBlocks(int width, int height, int size)
    : width_(width),
      height_(height),
      size_(size),
      columns_(divided_up(width, size)),
      rows_(divided_up(height, size)) {}

int ProbeBlocks::left() const {
    return columns_ * rows_ - static_cast<int>(used_.size());
}

std::vector<ProbeBlock> ProbeBlocks::next(int count) {
    std::vector<ProbeBlock> blocks;
    while (std::ssize(blocks) < count && left() > 0) {
        const auto [u, v] = even_point(next_++);
        ProbeBlock block{static_cast<int>(u * columns_), static_cast<int>(v * rows_)};
        while (!used_.emplace(block.x, block.y).second) {  // the next one in reading order
            block.x = (block.x + 1) % columns_;
            block.y = block.x == 0 ? (block.y + 1) % rows_ : block.y;
        }
        blocks.push_back(block);
    }
    return blocks;
}

void ProbeBlocks::add_tiles(const ProbeBlock& block, std::size_t number,
                            std::vector<ProbedTile>& tiles) const {
    const int across = size_ / kSide;
    for (int i = 0; i < across * across; ++i) {
        const int x = block.x * across + i % across;  // counted in tiles
        const int y = block.y * across + i / across;
        ProbedTile tile;
        tile.index = y * divided_up(width_, kSide) + x;
        tile.left = x * kSide;
        tile.top = y * kSide;
        tile.width = std::min(kSide, width_ - tile.left);
        tile.height = std::min(kSide, height_ - tile.top);
        tile.block = number;
        if (tile.width > 0 && tile.height > 0) {
            tiles.push_back(tile);
        }
    }
}

Film cut_block(const Film& whole, const ProbeBlock& block, int size) {
    Film film;
    film.width = size;
    film.height = size;
    for (const Channel& channel : whole.aovs) {
        film.aovs.push_back({channel.name, {}});
    }
    for (const HalfChannel& channel : whole.half_aovs) {
        film.half_aovs.push_back({channel.name, {}});
    }
    for (int i = 0; i < size * size; ++i) {
        const int x = std::min(block.x * size + i % size, whole.width - 1);
        const int y = std::min(block.y * size + i / size, whole.height - 1);
        const auto pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(whole.width) +
                           static_cast<std::size_t>(x);
        const float* rgba = &whole.rgba[4 * pixel];
        film.rgba.insert(film.rgba.end(), rgba, rgba + 4);
        for (std::size_t c = 0; c < film.aovs.size(); ++c) {
            film.aovs[c].values.push_back(whole.aovs[c].values[pixel]);
        }
        for (std::size_t c = 0; c < film.half_aovs.size(); ++c) {
            film.half_aovs[c].bits.push_back(whole.half_aovs[c].bits[pixel]);
        }
    }
    return film;
}

}  // namespace carom::render
