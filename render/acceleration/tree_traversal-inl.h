// Traversal of a wide tree by one ray, whose box tests have a child in each vector lane, or by a
// packet, whose box tests have a ray in each. Included once per instruction set.
#if defined(CAROM_TREE_TRAVERSAL_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CAROM_TREE_TRAVERSAL_INL_H
#undef CAROM_TREE_TRAVERSAL_INL_H
#else
#define CAROM_TREE_TRAVERSAL_INL_H
#endif

#include <bit>
#include <cstdint>
#include <utility>

#include "render/acceleration/kernels-inl.h"
#include "render/acceleration/wide_tree.h"
#include "render/geometry/ray.h"
#include "render/triangle/moller_trumbore-inl.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

namespace kernels = triangle::HWY_NAMESPACE;

namespace hn = hwy::HWY_NAMESPACE;

using PacketTag = hn::CappedTag<float, 16>;          // a ray in each lane
using ChildTag = hn::CappedTag<float, kBlockLanes>;  // a child's box in each lane
using PacketLanes = VectorLanes<PacketTag>;
using ChildLanes = VectorLanes<ChildTag>;
inline constexpr int kPacketLanes =
    static_cast<int>(HWY_LANES(float)) < 16 ? static_cast<int>(HWY_LANES(float)) : 16;

/// The order in which the children of a node are visited. For queries that end at any hit, sorting
/// does not pay.
enum class Order { nearest_first, any };

/// Children that wait to be visited, the next one last.
template <class Entry>
struct WaitingChildren {
    Entry entries[7 * kWideTreeDepth + 8];
    int count = 0;
};

/// One ray, which may be one of a packet.
class SingleRay {
  public:
    static constexpr bool kIsPacket = false;

    /// A child that waits to be visited, and where the ray enters it.
    struct Entry {
        float enter;
        std::int32_t child;
    };

    /// `limit`: where the search ends, which queries may lower; < 0: nowhere.
    HWY_INLINE SingleRay(const Ray& ray, const float& limit)
        : SingleRay(
              box_lines<ScalarLanes<float>>({ray.origin.x, ray.origin.y, ray.origin.z},
                                            {ray.direction.x, ray.direction.y, ray.direction.z}),
              ray.t_min, ray.time, limit) {}
    HWY_INLINE SingleRay(const BoxLines<ScalarLanes<float>>& line, float t_min, float time,
                         const float& limit)
        : limit_(limit), t_min_(ChildLanes::all(t_min)), time_(ChildLanes::all(time)) {
        for (int axis = 0; axis < 3; ++axis) {
            const float origins[2] = {line.low[axis], line.high[axis]};
            const int first =
                static_cast<int>(std::bit_cast<std::uint32_t>(line.inverse[axis]) >> 31u);
            first_side_[axis] = first;
            origin_[axis][0] = ChildLanes::all(origins[first]);
            origin_[axis][1] = ChildLanes::all(origins[1 - first]);
            inverse_[axis] = ChildLanes::all(line.inverse[axis]);
        }
    }

    [[nodiscard]] HWY_INLINE bool has_passed(const Entry& entry) const {
        return entry.enter > limit_;
    }

    /// Lets the children of a node wait that the ray enters, except for the next one, which takes
    /// the node's place. Returns false if there is none.
    template <Order kOrder, bool kMoving, class Nodes>
    HWY_INLINE bool enter_children(const Nodes& tree, Entry& current,
                                   WaitingChildren<Entry>& waiting) const {
        using L = ChildLanes;
        const ChildTag d;
        const auto index = static_cast<std::uint32_t>(current.child);
        const WideNode& node = tree.node(index);
        alignas(32) float enters[kBlockLanes];
        unsigned children = 0;
        for (int lane = 0; lane < kBlockLanes; lane += L::count()) {
            const auto at = [&](int axis, int side) HWY_ATTR {
                const int which = first_side_[axis] ^ side;
                auto plane = hn::Load(d, node.planes[axis][which].values + lane);
                if constexpr (kMoving) {
                    const auto travel =
                        hn::Load(d, tree.travel(index).planes[axis][which].values + lane);
                    plane = plane + time_ * travel;
                }
                return (plane - origin_[axis][side]) * inverse_[axis];
            };
            // In pairs: no result waits for more than two others.
            const auto enter =
                L::larger(L::larger(at(0, 0), at(1, 0)), L::larger(at(2, 0), t_min_));
            const auto leave =
                L::smaller(L::smaller(at(0, 1), at(1, 1)), L::smaller(at(2, 1), L::all(limit_)));
            std::uint8_t bits[8] = {};
            hn::StoreMaskBits(d, L::is_at_most(enter, leave), bits);
            hn::Store(enter, d, enters + lane);
            children |= static_cast<unsigned>(bits[0]) << lane;
        }
        if (children == 0) {
            return false;
        }
        const int first = std::countr_zero(children);
        current = {enters[first], node.children[first]};
        const int before = waiting.count;
        for (children &= children - 1; children != 0; children &= children - 1) {
            const int lane = std::countr_zero(children);
            Entry other{enters[lane], node.children[lane]};
            if (kOrder == Order::nearest_first && other.enter < current.enter) {
                std::swap(current, other);
            }
            int at = waiting.count++;
            for (; kOrder == Order::nearest_first && at > before &&
                   waiting.entries[at - 1].enter < other.enter;
                 --at) {
                waiting.entries[at] = waiting.entries[at - 1];
            }
            waiting.entries[at] = other;
        }
        return true;
    }

  private:
    const float& limit_;
    ChildLanes::Value t_min_, time_;
    ChildLanes::Value origin_[3][2];  // before the plane that is crossed first, and the other one
    ChildLanes::Value inverse_[3];
    int first_side_[3];
};

/// The box of a child.
template <class L>
HWY_INLINE PassageOf<L> passage(const WideNode& node, int lane, const BoxLines<L>& lines) {
    float planes[3][2];
    for (int axis = 0; axis < 3; ++axis) {
        planes[axis][0] = node.planes[axis][0].values[lane];
        planes[axis][1] = node.planes[axis][1].values[lane];
    }
    return passage(planes, lines);
}

/// The order of a node's children, the farthest first.
struct ChildOrder {
    struct Place {
        float nearest;
        int index;
    };
    Place places[kBlockLanes];
    int count = 0;

    HWY_INLINE void add(float nearest) {
        int at = count;
        for (; at > 0 && places[at - 1].nearest < nearest; --at) {
            places[at] = places[at - 1];
        }
        places[at] = {nearest, count++};
    }
};

/// How large a ray's coordinates are, by sum_of_sizes().
template <class L>
struct RaySizeOf {
    ValueOf<L> origin, direction;
};
template <class L>
HWY_INLINE RaySizeOf<L> size_of(const RayOf<L>& ray) {
    return {kernels::sum_of_sizes<L>(ray.origin), kernels::sum_of_sizes<L>(ray.direction)};
}

HWY_INLINE Vec3Of<PacketLanes> load_vector(const float (&numbers)[3][kPacketLanes]) {
    const PacketTag d;
    return {hn::Load(d, numbers[0]), hn::Load(d, numbers[1]), hn::Load(d, numbers[2])};
}

/// A ray in each lane, from distance 0 on.
struct alignas(64) PacketRays {
    static constexpr bool kIsPacket = true;
    /// The largest number of rays that go on alone, and of those that meet a leaf alone.
    static constexpr int kFew = 3;
    static constexpr int kFewInLeaf = 6;

    /// A child that waits to be visited, and where each ray enters it: infinity for those that
    /// miss.
    struct alignas(4 * kPacketLanes) Entry {
        float enter[kPacketLanes];
        std::int32_t child;

        Entry() = default;
        /// Copied as it is read: loads of whole vectors wait long for stores of their parts.
        HWY_INLINE Entry(const Entry& other) { *this = other; }
        HWY_INLINE Entry& operator=(const Entry& other) {
            const PacketTag d;
            hn::Store(hn::Load(d, other.enter), d, enter);
            child = other.child;
            return *this;
        }
    };

    float origin[3][kPacketLanes];
    float direction[3][kPacketLanes];
    float low[3][kPacketLanes], high[3][kPacketLanes], inverse[3][kPacketLanes];  // see BoxLines
    float origin_size[kPacketLanes], direction_size[kPacketLanes];                // see RaySizeOf
    float start[kPacketLanes];  // boxes count from here, and what is in them
    float limit[kPacketLanes];  // the search ends here; -1 for lanes without a ray
    float time[kPacketLanes];   // only for trees of instances

    /// Sets what tests of boxes and leaves need.
    HWY_INLINE void prepare() {
        const PacketTag d;
        const RayOf<PacketLanes> ray{load_vector(origin), load_vector(direction)};
        const auto& [o, w] = ray;
        const auto lines = box_lines<PacketLanes>({o.x, o.y, o.z}, {w.x, w.y, w.z});
        const auto size = size_of<PacketLanes>(ray);
        hn::Store(size.origin, d, origin_size);
        hn::Store(size.direction, d, direction_size);
        for (int axis = 0; axis < 3; ++axis) {
            hn::Store(lines.low[axis], d, low[axis]);
            hn::Store(lines.high[axis], d, high[axis]);
            hn::Store(lines.inverse[axis], d, inverse[axis]);
        }
    }

    [[nodiscard]] HWY_INLINE Entry root() const {
        const PacketTag d;
        Entry entry;
        hn::Store(hn::Load(d, start), d, entry.enter);
        entry.child = 0;
        return entry;
    }

    [[nodiscard]] HWY_INLINE SingleRay single(int ray) const {
        BoxLines<ScalarLanes<float>> line;
        for (int axis = 0; axis < 3; ++axis) {
            line.low[axis] = low[axis][ray];
            line.high[axis] = high[axis][ray];
            line.inverse[axis] = inverse[axis][ray];
        }
        return {line, start[ray], 0, limit[ray]};
    }

    /// The rays that enter a child before their limits.
    [[nodiscard]] HWY_INLINE PacketLanes::Mask active(const Entry& entry) const {
        const PacketTag d;
        return PacketLanes::is_at_most(hn::Load(d, entry.enter), hn::Load(d, limit));
    }

    /// go_alone() knows.
    [[nodiscard]] HWY_INLINE bool has_passed(const Entry& /*entry*/) const { return false; }

    /// If few rays or none enter the child, calls `go(ray, enter)` for each and returns true.
    template <class Go>
    [[nodiscard]] HWY_INLINE bool go_alone(const Entry& entry, const Go& go) const {
        const PacketTag d;
        const auto rays = active(entry);
        const int count = PacketLanes::count_of(rays);
        if (count > (entry.child < 0 ? kFewInLeaf : kFew) || count == 0) {
            return count == 0;
        }
        std::uint8_t bits[8] = {};
        hn::StoreMaskBits(d, rays, bits);
        for (unsigned left = bits[0] | static_cast<unsigned>(bits[1]) << 8u; left != 0;
             left &= left - 1) {
            const int ray = std::countr_zero(left);
            go(ray, entry.enter[ray]);
        }
        return true;
    }

    /// Lets the children of a node wait that rays enter. Returns false.
    template <Order kOrder, bool kMoving, class Nodes>
    HWY_INLINE bool enter_children(const Nodes& tree, const Entry& current,
                                   WaitingChildren<Entry>& waiting) const {
        static_assert(!kMoving);
        using L = PacketLanes;
        const PacketTag d;
        const auto rays = active(current);
        const auto end = hn::Load(d, limit);
        const auto begin = hn::Load(d, start);
        BoxLines<L> lines;
        for (int axis = 0; axis < 3; ++axis) {
            lines.low[axis] = hn::Load(d, low[axis]);
            lines.high[axis] = hn::Load(d, high[axis]);
            lines.inverse[axis] = hn::Load(d, inverse[axis]);
        }
        const WideNode& node = tree.node(static_cast<std::uint32_t>(current.child));
        Entry found[kBlockLanes];
        ChildOrder order;
        for (int lane = 0; lane < kBlockLanes && node.children[lane] != 0; ++lane) {
            const PassageOf<L> way = passage(node, lane, lines);
            const auto enter = L::larger(way.enter, begin);
            const auto inside = L::both(L::is_at_most(enter, L::smaller(way.leave, end)), rays);
            if (L::none(inside)) {
                continue;
            }
            const auto kept = L::select(inside, enter, L::all(kInfinity));
            Entry& child =
                kOrder == Order::any ? waiting.entries[waiting.count++] : found[order.count];
            hn::Store(kept, d, child.enter);
            child.child = node.children[lane];
            if constexpr (kOrder == Order::nearest_first) {
                order.add(hn::GetLane(hn::MinOfLanes(d, kept)));
            }
        }
        for (int i = 0; i < order.count; ++i) {
            waiting.entries[waiting.count++] = found[order.places[i].index];
        }
        return false;
    }
};

/// Visits the part of a tree below `current`. `query(leaf, entry)` tests the shapes of a leaf and
/// lowers limits; true ends the search. Rays of a packet that go on alone ask
/// `query.of_one(ray)`. `tree`: a WideTree, or what has its functions; `kMoving`: it has travels.
template <Order kOrder, bool kMoving = false, class Nodes, class Rays, class Query>
HWY_INLINE void traverse(const Nodes& tree, const Rays& rays, typename Rays::Entry current,
                         const Query& query) {
    WaitingChildren<typename Rays::Entry> waiting;
    const auto go_alone = [&]() HWY_ATTR __attribute__((always_inline)) {
        if constexpr (Rays::kIsPacket) {
            return rays.go_alone(
                current, [&](int ray, float enter) HWY_ATTR __attribute__((always_inline)) {
                    const SingleRay::Entry start{enter, current.child};
                    if (current.child < 0) {
                        query.of_one(ray)(static_cast<std::uint32_t>(-1 - current.child), start);
                    } else {
                        traverse<kOrder>(tree, rays.single(ray), start, query.of_one(ray));
                    }
                });
        } else {
            return false;
        }
    };
    for (;;) {
        if (!go_alone()) {
            if (current.child < 0) {
                if (query(static_cast<std::uint32_t>(-1 - current.child), current)) {
                    return;
                }
            } else if (rays.template enter_children<kOrder, kMoving>(tree, current, waiting)) {
                continue;
            }
        }
        do {
            if (waiting.count == 0) {
                return;
            }
            --waiting.count;
        } while (rays.has_passed(waiting.entries[waiting.count]));
        current = waiting.entries[waiting.count];
    }
}

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // once per instruction set
