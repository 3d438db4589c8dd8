// The blocks of a frame that a FrameProbe renders, and their tiles. Internal to this folder.
#pragma once

#include <cstddef>
#include <set>
#include <utility>
#include <vector>

#include "render/film/film.h"

namespace carom::render {

/// A block, counted in blocks from the top left of the frame.
struct ProbeBlock {
    int x = 0;
    int y = 0;
};

/// A tile of a block.
struct ProbedTile {
    int index = 0;  // in the frame
    int left = 0;   // pixels
    int top = 0;
    int width = 0;  // at the frame's edge less than a tile's
    int height = 0;
    std::size_t block = 0;
    double seconds = 0;        // CPU time spent on samples so far
    double fixed_seconds = 0;  // and on what does not depend on their number
    double taken = 0;          // samples, of all pixels
    double wanted = 0;         // the samples that its pixels need

    [[nodiscard]] double pixels() const { return static_cast<double>(width) * height; }
};

/// Chooses blocks in an order that spreads them over the frame.
class ProbeBlocks {
  public:
    /// `size`: of a block, in pixels; a multiple of a tile's.
    ProbeBlocks(int width, int height, int size);
    [[nodiscard]] int size() const { return size_; }

    /// The next `count` blocks, or all that are left if these are fewer.
    [[nodiscard]] std::vector<ProbeBlock> next(int count);
    [[nodiscard]] int left() const;

    /// Appends the tiles of a block, which is number `number` of all blocks.
    void add_tiles(const ProbeBlock& block, std::size_t number,
                   std::vector<ProbedTile>& tiles) const;

  private:
    int width_;  // of the frame, pixels
    int height_;
    int size_;     // of a block, pixels
    int columns_;  // of blocks
    int rows_;
    int next_ = 0;  // point of the sequence
    std::set<std::pair<int, int>> used_;
};

/// The pixels of a block; beyond the frame's edge those at the edge.
[[nodiscard]] Film cut_block(const Film& whole, const ProbeBlock& block, int size);

}  // namespace carom::render
