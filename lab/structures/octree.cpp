#include "lab/structures/octree.h"

#include <array>
#include <optional>

namespace carom::render {
namespace {

using Box = Imath::Box3f;
using Entry = BoxHierarchy::Entry;

constexpr int kFew = 4;
constexpr int kDeepest = 24;  // deeper, the centres practically coincide

/// The most leaves that hold a shape, on average: a cube is not divided if there would be more.
constexpr double kMostCopies = 8;

/// A cube, up to rounding: the parts of a cube have exactly the same faces in common.
struct Cube {
    Box box;

    /// Bit k of `part` is set in the upper half along axis k.
    [[nodiscard]] Cube part(std::size_t part) const {
        const V3f middle = box.center();
        Cube result = *this;
        for (int axis = 0; axis < 3; ++axis) {
            (part >> axis & 1u ? result.box.min : result.box.max)[axis] = middle[axis];
        }
        return result;
    }
    [[nodiscard]] std::size_t part_of(const V3f& point) const {
        const V3f middle = box.center();
        return (point.x > middle.x ? 1u : 0u) + (point.y > middle.y ? 2u : 0u) +
               (point.z > middle.z ? 4u : 0u);
    }
    [[nodiscard]] float edge() const { return box.max.x - box.min.x; }
    /// The same cube, twice as wide.
    [[nodiscard]] Box loose_box() const {
        const V3f half = 0.5f * box.size();
        return {box.min - half, box.max + half};
    }
};

Cube around(const Box& box) {
    const V3f size = box.size();
    const V3f half(0.5f * std::max({size.x, size.y, size.z}));
    Cube cube{{box.center() - half, box.center() + half}};
    cube.box.extendBy(box);  // where rounding made it narrower
    return cube;
}

Box intersection(const Box& a, const Box& b) {
    Box both;
    for (int axis = 0; axis < 3; ++axis) {
        both.min[axis] = std::max(a.min[axis], b.min[axis]);
        both.max[axis] = std::min(a.max[axis], b.max[axis]);
    }
    return both;
}

bool contains(const Box& outer, const Box& inner) {
    return outer.intersects(inner.min) && outer.intersects(inner.max);
}

template <CubePlacement placement>
class Builder {
  public:
    Builder(const std::vector<Box>& boxes, const StructureSizes& sizes, BoxHierarchy& result)
        : result_(result), few_(sizes.leaf_capacity_or(kFew)) {
        Entries all;
        Box centres;
        for (std::uint32_t shape = 0; shape < boxes.size(); ++shape) {
            all.push_back({boxes[shape], shape, true});
            bounds_.extendBy(boxes[shape]);
            centres.extendBy(boxes[shape].center());
        }
        if (!all.empty()) {
            const Box& region = placement == CubePlacement::centre ? centres : bounds_;
            build(all, around(region), kMostCopies, 0);
        }
    }

  private:
    using Entries = std::vector<Entry>;

    struct Parts {
        Entries here;  // entries that no part takes
        std::array<Entries, 8> parts;
        std::size_t count = 0;  // of all entries, with their copies
    };

    /// Adds a node for these entries. `copies`: how often each of them may still be copied.
    std::uint32_t build(const Entries& shapes, const Cube& cube, double copies, int depth) {
        if (shapes.size() <= few_ || depth == kDeepest) {
            return result_.add_node(shapes);
        }
        Parts parts = divided(shapes, cube);
        const double growth = static_cast<double>(parts.count) / static_cast<double>(shapes.size());
        if (growth > copies) {
            return result_.add_node(shapes);
        }
        Entries& entries = parts.here;
        for (std::size_t part = 0; part < parts.parts.size(); ++part) {
            const Entries& of_part = parts.parts[part];
            // An unfitted cube is entered also for a single shape.
            if (of_part.size() == 1 && placement != CubePlacement::overlapping) {
                entries.push_back(of_part[0]);
            } else if (!of_part.empty()) {
                const std::uint32_t below =
                    build(of_part, cube.part(part), copies / growth, depth + 1);
                entries.push_back({box_of(below, cube.part(part)), below, false});
            }
        }
        return result_.add_node(entries);
    }

    /// What a ray must enter to visit the node.
    [[nodiscard]] Box box_of(std::uint32_t node, const Cube& cube) const {
        if constexpr (placement == CubePlacement::overlapping) {
            return intersection(cube.box, bounds_);
        } else if constexpr (placement == CubePlacement::loose) {
            return intersection(cube.loose_box(), bounds_);
        } else {
            return result_.box_of(node);
        }
    }

    [[nodiscard]] static Parts divided(const Entries& shapes, const Cube& cube) {
        Parts result;
        for (const Entry& shape : shapes) {
            const std::size_t before = result.count;
            divide(shape, cube, result);
            if (result.count == before) {
                result.here.push_back(shape);
                result.count += 1;
            }
        }
        return result;
    }

    /// Adds the shape to its parts, if it has any.
    static void divide(const Entry& shape, const Cube& cube, Parts& result) {
        if constexpr (has_copies(placement)) {
            for (std::size_t part = 0; part < result.parts.size(); ++part) {
                const Box inside = intersection(shape.box, cube.part(part).box);
                if (!inside.isEmpty()) {
                    const Box& kept = placement == CubePlacement::cut ? inside : shape.box;
                    result.parts[part].push_back({kept, shape.index, true});
                    result.count += 1;
                }
            }
        } else {
            const std::size_t part = cube.part_of(shape.box.center());
            if (fits(shape.box, cube.part(part))) {
                result.parts[part].push_back(shape);
                result.count += 1;
            }
        }
    }

    [[nodiscard]] static bool fits(const Box& box, const Cube& cube) {
        if constexpr (placement == CubePlacement::centre) {
            return true;
        } else if constexpr (placement == CubePlacement::loose) {
            return contains(cube.loose_box(), box) &&
                   box.size()[static_cast<int>(box.majorAxis())] <= cube.edge();
        } else {
            return contains(cube.box, box);
        }
    }

    BoxHierarchy& result_;
    std::size_t few_;
    Box bounds_;  // of all shapes
};

}  // namespace

template <CubePlacement placement>
Octree<placement>::Octree(const Primitives& primitives, const StructureSizes& sizes) {
    const std::vector<Box> boxes = swept_boxes(primitives);
    Builder<placement>(boxes, sizes, *this);
}

template class Octree<CubePlacement::centre>;
template class Octree<CubePlacement::loose>;
template class Octree<CubePlacement::enclosing>;
template class Octree<CubePlacement::overlapping>;
template class Octree<CubePlacement::cut>;

}  // namespace carom::render
