#include "lab/structures/octree.h"

#include <array>
#include <numeric>
#include <span>

namespace carom::render {
namespace {

using Box = Imath::Box3f;

constexpr std::size_t kFew = 4;
constexpr int kDeepest = 24;  // deeper, the centres practically coincide

class Builder {
  public:
    Builder(const std::vector<Box>& boxes, BoxHierarchy& result) : boxes_(boxes), result_(result) {
        std::vector<std::uint32_t> all(boxes.size());
        std::iota(all.begin(), all.end(), 0u);
        Box centres;
        for (const Box& box : boxes) {
            centres.extendBy(box.center());
        }
        if (!all.empty()) {
            const V3f size = centres.size();
            const float half = 0.5f * std::max({size.x, size.y, size.z});
            build(all, centres.center(), half, 0);
        }
    }

  private:
    // `half`: of the cube's edge.
    std::uint32_t build(std::span<const std::uint32_t> shapes, const V3f& middle, float half,
                        int depth) {
        std::vector<BoxHierarchy::Entry> entries;
        if (shapes.size() <= kFew || depth == kDeepest) {
            for (const std::uint32_t shape : shapes) {
                entries.push_back({boxes_[shape], shape, true});
            }
            return result_.add_node(entries);
        }
        std::array<std::vector<std::uint32_t>, 8> parts;
        for (const std::uint32_t shape : shapes) {
            const V3f centre = boxes_[shape].center();
            const std::size_t part = (centre.x > middle.x ? 1u : 0u) +
                                     (centre.y > middle.y ? 2u : 0u) +
                                     (centre.z > middle.z ? 4u : 0u);
            parts[part].push_back(shape);
        }
        for (std::size_t part = 0; part < parts.size(); ++part) {
            if (parts[part].empty()) {
                continue;
            }
            if (parts[part].size() == 1) {
                entries.push_back({boxes_[parts[part][0]], parts[part][0], true});
                continue;
            }
            const float quarter = 0.5f * half;
            const V3f shift(part & 1u ? quarter : -quarter, part & 2u ? quarter : -quarter,
                            part & 4u ? quarter : -quarter);
            const std::uint32_t below = build(parts[part], middle + shift, quarter, depth + 1);
            entries.push_back(result_.entry_of(below));
        }
        return result_.add_node(entries);
    }

    const std::vector<Box>& boxes_;
    BoxHierarchy& result_;
};

}  // namespace

Octree::Octree(const Primitives& primitives) {
    const std::vector<Box> boxes = swept_boxes(primitives);
    Builder(boxes, *this);
}

}  // namespace carom::render
