#include "render/acceleration/analytic_tree.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "render/acceleration/shape_bounds.h"

namespace carom::render {
namespace {

/// A shape: its number in the list (TreePart::kMoving for moving shapes) and its index there.
struct Listed {
    std::uint32_t shape = 0;
    std::uint32_t index = 0;
};

/// Lists all bounded shapes of a set.
class Lister {
  public:
    explicit Lister(const ShapeSet& shapes) {
        shapes.blocks.each([&](const auto& list) { add(list); });
        for (std::uint32_t i = 0; i < shapes.moving.size(); ++i) {
            if (!shapes.moving[i].is_infinite()) {
                items.push_back({TreePart::kMoving, i});
                bounds.push_back(bounds_of(shapes.moving[i]));
            }
        }
    }

    std::vector<Listed> items;
    std::vector<MovingBounds> bounds;

  private:
    template <class Shape>
    void add(const BlockList<Shape>& list) {
        if constexpr (Shape::kIsBounded) {
            for (std::uint32_t i = 0; i < list.size; ++i) {
                items.push_back({kLaneShape<Shape>, i});
                bounds.push_back(bounds_of(list, i));
            }
        }
    }
};

class TreeMaker {
  public:
    explicit TreeMaker(const ShapeSet& shapes) : shapes_(shapes), list_(shapes) {}

    AnalyticTree make() {
        tree_.tree = build_wide_tree(list_.bounds);
        tree_.moving = shapes_.moving;
        for (const WideLeaf& leaf : tree_.tree.leaves) {
            tree_.first_part.push_back(static_cast<std::uint32_t>(tree_.parts.size()));
            add_moving(leaf);
            shapes_.blocks.each([&](const auto& list) { add_block(leaf, list); });
        }
        tree_.first_part.push_back(static_cast<std::uint32_t>(tree_.parts.size()));
        return std::move(tree_);
    }

  private:
    [[nodiscard]] const Listed& item(std::uint32_t i) const {
        return list_.items[tree_.tree.order[i]];
    }

    void add_moving(const WideLeaf& leaf) {
        for (std::uint32_t i = leaf.first; i < leaf.first + leaf.count; ++i) {
            if (item(i).shape == TreePart::kMoving) {
                tree_.parts.push_back({TreePart::kMoving, item(i).index});
            }
        }
    }

    /// Appends the leaf's shapes of one kind, which fit into one block, to the earlier leaves'
    /// shapes.
    template <class Shape>
    void add_block(const WideLeaf& leaf, const BlockList<Shape>& all) {
        BlockList<Shape> few;
        for (std::uint32_t i = leaf.first; i < leaf.first + leaf.count; ++i) {
            if (item(i).shape == kLaneShape<Shape>) {
                few.add_from(all, item(i).index);
            }
        }
        BlockList<Shape>& target = tree_.blocks.template of<Shape>();
        for (const auto& block : few.blocks) {
            tree_.parts.push_back(
                {kLaneShape<Shape>, static_cast<std::uint32_t>(target.blocks.size())});
            target.blocks.push_back(block);
        }
    }

    const ShapeSet& shapes_;
    Lister list_;
    AnalyticTree tree_;
};

}  // namespace

AnalyticTree make_analytic_tree(const ShapeSet& shapes) {
    return TreeMaker(shapes).make();
}

ShapeSet infinite_shapes(const ShapeSet& shapes) {
    ShapeSet infinite;
    shapes.blocks.each([&]<class Shape>(const BlockList<Shape>& list) {
        if constexpr (!Shape::kIsBounded) {
            infinite.blocks.of<Shape>() = list;
        }
    });
    std::copy_if(shapes.moving.begin(), shapes.moving.end(), std::back_inserter(infinite.moving),
                 [](const MovingShape& shape) { return shape.is_infinite(); });
    return infinite;
}

// A turning shape is tested alone, but only by the rays of a batch that meet its box. (Frames of 32
// falling dominoes take a seventh less time in loops than in a tree.)
constexpr std::size_t kCostOfTurning = 2;

std::size_t loop_cost(const ShapeSet& shapes) {
    std::size_t cost = 0;
    shapes.blocks.each([&]<class Shape>(const BlockList<Shape>& list) {
        cost += Shape::kIsBounded ? list.size : 0;
    });
    for (const MovingShape& shape : shapes.moving) {
        cost += shape.is_infinite() ? 0 : kCostOfTurning;
    }
    return cost;
}

}  // namespace carom::render
