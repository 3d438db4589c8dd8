// All static analytic shapes and plain spheres in blocks, with a list for each shape.
#pragma once

#include <cstddef>
#include <cstring>
#include <type_traits>
#include <vector>

#include "render/acceleration/shape_list.h"

namespace carom::render {

/// Copies one lane of a block into a lane of another.
template <class Block>
void copy_lane(const Block& from, int lane, Block& to, int to_lane) {
    static_assert(std::is_trivially_copyable_v<Block> && sizeof(Block) % sizeof(FloatLanes) == 0,
                  "a block is rows of lanes");
    constexpr std::size_t kNumber = sizeof(float);
    const auto* source = reinterpret_cast<const std::byte*>(&from);
    auto* target = reinterpret_cast<std::byte*>(&to);
    for (std::size_t row = 0; row < sizeof(Block); row += sizeof(FloatLanes)) {
        std::memcpy(target + row + static_cast<std::size_t>(to_lane) * kNumber,
                    source + row + static_cast<std::size_t>(lane) * kNumber, kNumber);
    }
}

template <class Shape>
struct BlockList {
    using Block = typename Shape::Block;

    struct Lane {
        Block& block;
        int lane;
    };

    std::vector<Block> blocks;
    std::uint32_t size = 0;  // lanes in use, from the first on

    /// Returns the next lane with its object set; the caller sets the rest.
    Lane add(std::uint32_t object) {
        const int lane = static_cast<int>(size++ % kBlockLanes);
        if (lane == 0) {
            blocks.emplace_back();
        }
        blocks.back().object.values[lane] = static_cast<std::int32_t>(object);
        return {blocks.back(), lane};
    }
    /// Appends a copy of lane `index` of `other`.
    void add_from(const BlockList& other, std::uint32_t index) {
        const Lane added = add(other.object(index));
        copy_lane(other.blocks[index / kBlockLanes], static_cast<int>(index % kBlockLanes),
                  added.block, added.lane);
    }
    [[nodiscard]] std::uint32_t object(std::uint32_t index) const {
        const Block& block = blocks[index / kBlockLanes];
        return static_cast<std::uint32_t>(block.object.values[index % kBlockLanes]);
    }
};

template <class List>
struct BlockLists;
template <class... Shapes>
struct BlockLists<ShapeList<Shapes...>> : BlockList<Shapes>... {
    template <class Shape>
    [[nodiscard]] BlockList<Shape>& of() {
        return *this;
    }
    template <class Shape>
    [[nodiscard]] const BlockList<Shape>& of() const {
        return *this;
    }
    /// Calls `visitor(list)` with the list of each shape.
    template <class Visitor>
    void each(const Visitor& visitor) const {
        (visitor(of<Shapes>()), ...);
    }
};

using AnalyticBlocks = BlockLists<LaneShapes>;

}  // namespace carom::render
