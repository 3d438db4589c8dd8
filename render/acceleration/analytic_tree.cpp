#include "render/acceleration/analytic_tree.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace carom::render {
namespace {

using Kind = TreePart::Kind;

bool is_plane(const MovingShape& shape) {
    return shape.kind == MovingShape::Kind::plane;
}

/// A shape by the list of the set that it is in.
struct Listed {
    std::vector<SphereStretch> const* spheres = nullptr;
    std::vector<AlignedBox> const* boxes = nullptr;
    std::vector<MappedShape> const* mapped = nullptr;
    std::vector<MappedShape> ShapeSet::*mapped_list = nullptr;
    std::uint32_t index = 0;
};

class Lister {
  public:
    explicit Lister(const ShapeSet& shapes) {
        const auto add = [&](const auto& shape, const Listed& listed) {
            items.push_back(listed);
            bounds.push_back(bounds_of(shape));
        };
        for (std::uint32_t i = 0; i < shapes.spheres.size(); ++i) {
            add(shapes.spheres[i], {&shapes.spheres, nullptr, nullptr, nullptr, i});
        }
        for (std::uint32_t i = 0; i < shapes.boxes.size(); ++i) {
            add(shapes.boxes[i], {nullptr, &shapes.boxes, nullptr, nullptr, i});
        }
        add_mapped(shapes, &ShapeSet::mapped_balls, false);
        add_mapped(shapes, &ShapeSet::mapped_boxes, false);
        add_mapped(shapes, &ShapeSet::frustums, false);
        add_mapped(shapes, &ShapeSet::rectangles, true);
        add_mapped(shapes, &ShapeSet::triangles, true);
        add_mapped(shapes, &ShapeSet::disks, true);
        for (std::uint32_t i = 0; i < shapes.moving.size(); ++i) {
            if (!is_plane(shapes.moving[i])) {
                add(shapes.moving[i], {nullptr, nullptr, nullptr, nullptr, i});
            }
        }
    }

    std::vector<Listed> items;
    std::vector<MovingBounds> bounds;

  private:
    void add_mapped(const ShapeSet& shapes, std::vector<MappedShape> ShapeSet::*list, bool flat) {
        const std::vector<MappedShape>& mapped = shapes.*list;
        for (std::uint32_t i = 0; i < mapped.size(); ++i) {
            items.push_back({nullptr, nullptr, &mapped, list, i});
            bounds.push_back(bounds_of(mapped[i], flat));
        }
    }
};

/// Moves one leaf's blocks behind those of the leaves before.
template <class Block>
void append(std::vector<TreePart>& parts, Kind kind, std::vector<Block>& all,
            const std::vector<Block>& more) {
    for (const Block& block : more) {
        parts.push_back({kind, static_cast<std::uint32_t>(all.size())});
        all.push_back(block);
    }
}

void append_all(AnalyticTree& tree, const AnalyticBlocks& more) {
    AnalyticBlocks& all = tree.blocks;
    append(tree.parts, Kind::still_spheres, all.still_spheres, more.still_spheres);
    append(tree.parts, Kind::moving_spheres, all.moving_spheres, more.moving_spheres);
    append(tree.parts, Kind::boxes, all.boxes, more.boxes);
    append(tree.parts, Kind::mapped_balls, all.mapped_balls, more.mapped_balls);
    append(tree.parts, Kind::mapped_boxes, all.mapped_boxes, more.mapped_boxes);
    append(tree.parts, Kind::rectangles, all.rectangles, more.rectangles);
    append(tree.parts, Kind::triangles, all.triangles, more.triangles);
    append(tree.parts, Kind::disks, all.disks, more.disks);
    append(tree.parts, Kind::frustums, all.frustums, more.frustums);
}

}  // namespace

AnalyticTree make_analytic_tree(const ShapeSet& shapes) {
    const Lister list(shapes);
    AnalyticTree result;
    result.tree = build_wide_tree(list.bounds);
    result.moving = shapes.moving;
    for (const WideLeaf& leaf : result.tree.leaves) {
        result.first_part.push_back(static_cast<std::uint32_t>(result.parts.size()));
        ShapeSet few;
        for (std::uint32_t i = leaf.first; i < leaf.first + leaf.count; ++i) {
            const Listed& item = list.items[result.tree.order[i]];
            if (item.spheres != nullptr) {
                few.spheres.push_back((*item.spheres)[item.index]);
            } else if (item.boxes != nullptr) {
                few.boxes.push_back((*item.boxes)[item.index]);
            } else if (item.mapped != nullptr) {
                (few.*item.mapped_list).push_back((*item.mapped)[item.index]);
            } else {
                result.parts.push_back({Kind::moving_shape, item.index});
            }
        }
        append_all(result, make_blocks(few));
    }
    result.first_part.push_back(static_cast<std::uint32_t>(result.parts.size()));
    return result;
}

ShapeSet infinite_planes(const ShapeSet& shapes) {
    ShapeSet planes;
    planes.planes = shapes.planes;
    std::copy_if(shapes.moving.begin(), shapes.moving.end(), std::back_inserter(planes.moving),
                 is_plane);
    return planes;
}

std::size_t loop_cost(const ShapeSet& shapes) {
    const auto planes = std::count_if(shapes.moving.begin(), shapes.moving.end(), is_plane);
    const std::size_t turning = shapes.moving.size() - static_cast<std::size_t>(planes);
    return shapes.spheres.size() + shapes.boxes.size() + shapes.mapped_balls.size() +
           shapes.mapped_boxes.size() + shapes.rectangles.size() + shapes.triangles.size() +
           shapes.disks.size() + shapes.frustums.size() + kBlockLanes * turning;
}

}  // namespace carom::render
