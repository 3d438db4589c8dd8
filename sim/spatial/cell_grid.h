// A uniform grid that finds balls near each other, seen from above.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "sim/motion/motion_segment.h"

namespace carom::sim {

/// A square cell of the plane z = 0, counted from the origin.
struct Cell {
    std::int32_t x = 0;
    std::int32_t y = 0;

    [[nodiscard]] friend bool operator==(const Cell&, const Cell&) = default;
};

/// Items (numbers below `count`), each in one cell of an infinite grid. Two items closer to each
/// other than the cell width are in the same cell or in neighbouring ones, provided that each one
/// is moved by `cross` at the time of `next_crossing`. Items may be outside of their cells by up to
/// kCellMargin.
class CellGrid {
  public:
    enum class Side : std::uint8_t { left, right, front, back };
    struct Crossing {
        double time = 0;
        Side to = Side::left;
    };

    CellGrid(double width, std::size_t count);

    /// Moves the item to the cell of `position` unless it already is in that cell.
    void place(std::uint32_t item, const Vec3& position);

    /// The first crossing into another cell in [now, until] of the item that moves along `path`.
    [[nodiscard]] std::optional<Crossing> next_crossing(std::uint32_t item,
                                                        const MotionSegment& path, double now,
                                                        double until) const;
    void cross(std::uint32_t item, Side to);

    /// Replaces `found` by the other items in its cell and the eight cells around it.
    void find_near(std::uint32_t item, std::vector<std::uint32_t>& found) const;
    /// Replaces `found` by the items in the three cells that became neighbours when it crossed to
    /// the side `to`.
    void find_ahead(std::uint32_t item, Side to, std::vector<std::uint32_t>& found) const;

    [[nodiscard]] Cell cell_of(std::uint32_t item) const { return cells_[item]; }

  private:
    [[nodiscard]] std::int32_t coordinate(double value) const;
    [[nodiscard]] std::size_t bucket_of(Cell cell) const;
    void find_in(Cell cell, std::uint32_t item, std::vector<std::uint32_t>& found) const;
    void link(std::uint32_t item);
    void unlink(std::uint32_t item);

    double width_;
    // Cells are hashed into buckets, each of which is a list linked through its items.
    std::vector<Cell> cells_;
    std::vector<std::uint32_t> next_, previous_;
    std::vector<std::uint32_t> buckets_;
};

/// An item may be this far outside of its cell (m) before `place` moves it.
inline constexpr double kCellMargin = 1e-4;

}  // namespace carom::sim
