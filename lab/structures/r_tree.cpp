#include "lab/structures/r_tree.h"

#include <array>
#include <cmath>

namespace carom::render {
namespace {

using Entry = BoxHierarchy::Entry;
using Iterator = std::vector<Entry>::iterator;

constexpr int kCapacity = 4;

void sort_by(Iterator begin, Iterator end, int axis) {
    std::sort(begin, end, [axis](const Entry& a, const Entry& b) {
        const float at_a = a.box.min[axis] + a.box.max[axis];
        const float at_b = b.box.min[axis] + b.box.max[axis];
        return at_a < at_b || (at_a == at_b && a.index < b.index);
    });
}

// Each slice holds a whole number of nodes, so that only the very last node is not full.
void tile(Iterator begin, Iterator end, std::size_t capacity, int axis) {
    sort_by(begin, end, axis);
    if (axis == 2) {
        return;
    }
    const auto count = static_cast<std::size_t>(end - begin);
    const double nodes = std::ceil(static_cast<double>(count) / static_cast<double>(capacity));
    const double slices = std::ceil(std::pow(nodes, 1.0 / (3 - axis)));
    const auto step = static_cast<std::size_t>(std::ceil(nodes / slices)) * capacity;
    for (std::size_t first = 0; first < count; first += step) {
        const std::size_t last = std::min(count, first + step);
        tile(begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(last),
             capacity, axis + 1);
    }
}

// Index along a Hilbert curve through 2^21 cells per edge.
std::uint64_t hilbert_place(std::array<std::uint32_t, 3> x) {
    constexpr int kBits = 21;
    constexpr std::uint32_t kTop = 1u << (kBits - 1);
    for (std::uint32_t q = kTop; q > 1; q >>= 1) {
        const std::uint32_t p = q - 1;
        for (std::uint32_t& coordinate : x) {
            if ((coordinate & q) != 0) {
                x[0] ^= p;
            } else {
                const std::uint32_t t = (x[0] ^ coordinate) & p;
                x[0] ^= t;
                coordinate ^= t;
            }
        }
    }
    x[1] ^= x[0];
    x[2] ^= x[1];
    std::uint32_t t = 0;
    for (std::uint32_t q = kTop; q > 1; q >>= 1) {
        t ^= (x[2] & q) != 0 ? q - 1 : 0;
    }
    std::uint64_t place = 0;
    for (int bit = kBits - 1; bit >= 0; --bit) {
        for (const std::uint32_t coordinate : x) {
            place = place << 1 | ((coordinate ^ t) >> bit & 1u);
        }
    }
    return place;
}

void sort_along_curve(std::vector<Entry>& entries) {
    Imath::Box3f centres;
    for (const Entry& entry : entries) {
        centres.extendBy(entry.box.center());
    }
    struct Placed {
        std::uint64_t place;
        Entry entry;
    };
    std::vector<Placed> placed;
    placed.reserve(entries.size());
    const V3f size = centres.size();
    const float edge = std::max({size.x, size.y, size.z, 1e-30f});
    constexpr float kCells = 0x1p21f - 1;
    for (const Entry& entry : entries) {
        const V3f at = (entry.box.center() - centres.min) / edge;
        const auto cell = [](float fraction) {
            return static_cast<std::uint32_t>(fraction * kCells);
        };
        placed.push_back({hilbert_place({cell(at.x), cell(at.y), cell(at.z)}), entry});
    }
    std::sort(placed.begin(), placed.end(), [](const Placed& a, const Placed& b) {
        return a.place < b.place || (a.place == b.place && a.entry.index < b.entry.index);
    });
    for (std::size_t i = 0; i < entries.size(); ++i) {
        entries[i] = placed[i].entry;
    }
}

template <Packing packing>
void sort_level(std::vector<Entry>& level, std::size_t capacity, int number) {
    if constexpr (packing == Packing::sort_tile_recursive) {
        tile(level.begin(), level.end(), capacity, 0);
    } else if constexpr (packing == Packing::cyclic) {
        sort_by(level.begin(), level.end(), number % 3);
    } else if (number == 0) {
        sort_along_curve(level);  // nodes keep the order of their contents
    }
}

}  // namespace

template <Packing packing>
RTree<packing>::RTree(const Primitives& primitives, const StructureSizes& sizes) {
    const auto capacity =
        static_cast<std::size_t>(sizes.node_capacity > 0 ? sizes.node_capacity : kCapacity);
    std::vector<Entry> level;
    const std::vector<Imath::Box3f> boxes = swept_boxes(primitives);
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
        level.push_back({boxes[i], i, true});
    }
    for (int number = 0; level.size() > 1 || (number == 0 && !level.empty()); ++number) {
        sort_level<packing>(level, capacity, number);
        std::vector<Entry> above;
        for (std::size_t first = 0; first < level.size(); first += capacity) {
            const std::size_t last = std::min(level.size(), first + capacity);
            const std::vector<Entry> entries(level.begin() + static_cast<std::ptrdiff_t>(first),
                                             level.begin() + static_cast<std::ptrdiff_t>(last));
            above.push_back(this->entry_of(this->add_node(entries)));
        }
        level = std::move(above);
    }
}

template class RTree<Packing::sort_tile_recursive>;
template class RTree<Packing::cyclic>;
template class RTree<Packing::hilbert>;

}  // namespace carom::render
