// The binary tree out of which a wide tree is cut. Internal to this folder.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "render/acceleration/shape_bounds.h"

namespace carom::render {

struct BinaryNode {
    MovingBounds bounds;
    float area = 0;                      // at the middle of the shutter
    std::uint32_t first = 0, count = 0;  // items
    std::uint32_t left = 0, right = 0;   // 0: a leaf
    [[nodiscard]] bool is_leaf() const { return left == 0; }
};

struct BinaryTree {
    std::vector<BinaryNode> nodes;  // children after their parents, left ones first
    std::vector<std::uint32_t> order;
};

/// How many full leaves are as much work as these items.
[[nodiscard]] inline float full_leaves(std::uint32_t count, std::uint32_t largest_leaf) {
    const std::uint32_t whole = (count + largest_leaf - 1) / largest_leaf;
    return static_cast<float>(whole);
}

/// See build_wide_tree().
[[nodiscard]] BinaryTree build_binary_tree(std::span<const MovingBounds> items,
                                           std::uint32_t largest_leaf);

}  // namespace carom::render
