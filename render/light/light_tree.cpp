#include "render/light/light_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "core/elementary.h"
#include "core/elementary_float.h"

namespace carom::render {
namespace {

float sine_of(float angle) {
    return static_cast<float>(sine(static_cast<double>(angle)));
}
float cosine_of(float angle) {
    return static_cast<float>(cosine(static_cast<double>(angle)));
}

float angle_between(const V3f& a, const V3f& b) {
    // Accurate for small angles, too.
    return 2 * arcsine(std::min(1.0f, 0.5f * (a - b).length()));
}

/// `v`, turned by an angle towards `to`.
V3f turned(const V3f& v, const V3f& to, float angle) {
    V3f across = to - v * v.dot(to);
    if (!(across.length() > 1e-6f)) {  // opposite: any way is the shortest
        across = v.cross(std::abs(v.x) < 0.5f ? V3f(1, 0, 0) : V3f(0, 1, 0));
    }
    return (v * cosine_of(angle) + across.normalized() * sine_of(angle)).normalized();
}

/// The measure of the directions that light leaves in (Conty Estevez and Kulla 2018, equation 1).
float measure_of_directions(const LightBounds& bounds) {
    const float widest = std::min(kPi, bounds.spread + bounds.reach);
    const float sine_of_spread = sine_of(bounds.spread);
    const float cosine_of_spread = cosine_of(bounds.spread);
    return kTurn * (1 - cosine_of_spread) +
           0.5f * kPi *
               (2 * widest * sine_of_spread - cosine_of(bounds.spread - 2 * widest) -
                2 * bounds.spread * sine_of_spread + cosine_of_spread);
}

float surface_of(const Imath::Box3f& box) {
    const V3f size = box.size();
    return size.x * size.y + size.y * size.z + size.z * size.x;
}

float cost_of(const LightBounds& bounds) {
    return bounds.strength * measure_of_directions(bounds) * surface_of(bounds.box);
}

/// A place to split: lights whose centre along the axis is below it go to the left.
struct Split {
    float cost = 0;
    int axis = -1;
    float below = 0;
};

constexpr std::size_t kBuckets = 12;

/// The least cost of splitting along an axis; infinite if the centres coincide there.
template <class Entries>
Split best_split(const Entries& entries, const Imath::Box3f& centres, int axis) {
    const float low = centres.min[axis];
    const float width = centres.max[axis] - low;
    if (!(width > 0)) {
        return {INFINITY, -1, 0};
    }
    std::array<LightBounds, kBuckets> buckets;
    const auto bucket_of = [&](float centre) {
        const float place = (centre - low) / width * static_cast<float>(kBuckets);
        return std::min(kBuckets - 1, static_cast<std::size_t>(place));
    };
    for (const auto& entry : entries) {
        LightBounds& bucket = buckets[bucket_of(entry.bounds.box.center()[axis])];
        bucket = bucket.with(entry.bounds);
    }
    std::array<float, kBuckets> above{};
    LightBounds sum;
    for (std::size_t i = kBuckets - 1; i > 0; --i) {
        sum = sum.with(buckets[i]);
        above[i] = sum.strength > 0 ? cost_of(sum) : INFINITY;
    }
    Split best{INFINITY, -1, 0};
    sum = LightBounds();
    for (std::size_t i = 1; i < kBuckets; ++i) {
        sum = sum.with(buckets[i - 1]);
        const float cost = sum.strength > 0 ? cost_of(sum) + above[i] : INFINITY;
        if (cost < best.cost) {
            best = {cost, axis, low + width * static_cast<float>(i) / static_cast<float>(kBuckets)};
        }
    }
    return best;
}

}  // namespace

LightBounds LightBounds::with(const LightBounds& other) const {
    if (!(strength > 0) || !(other.strength > 0)) {
        return strength > 0 ? *this : other;
    }
    const bool is_wider = spread >= other.spread;
    const LightBounds& wide = is_wider ? *this : other;
    const LightBounds& narrow = is_wider ? other : *this;
    LightBounds both = wide;
    both.box.extendBy(narrow.box);
    both.strength += narrow.strength;
    both.reach = std::max(reach, other.reach);
    const float between = angle_between(wide.axis, narrow.axis);
    if (between + narrow.spread <= wide.spread) {
        return both;
    }
    both.spread = 0.5f * (wide.spread + between + narrow.spread);
    if (both.spread >= kPi) {
        both.spread = kPi;
    } else {
        both.axis = turned(wide.axis, narrow.axis, both.spread - wide.spread);
    }
    return both;
}

LightTree::LightTree(const std::vector<LightBounds>& lights) : leaf_of_light_(lights.size(), -1) {
    std::vector<Entry> entries;
    for (std::size_t light = 0; light < lights.size(); ++light) {
        if (lights[light].strength > 0) {
            entries.push_back({lights[light], static_cast<std::int32_t>(light)});
        }
    }
    if (entries.empty()) {
        return;
    }
    const Group all = group_of(entries);
    bounds_ = all.bounds;
    shines_all_around_ = std::all_of(entries.begin(), entries.end(),
                                     [](const Entry& entry) { return entry.bounds.spread >= kPi; });
    add(all, entries.data(), -1);
    build(0, all, entries.data(), LightTreeData::kMostOfRoot);
    double before = 0;
    strength_before_ = {0};
    for (const Entry& entry : entries) {
        before += static_cast<double>(entry.bounds.strength);
        strength_before_.push_back(static_cast<float>(before));
        lights_.push_back(entry.light);
    }
}

LightTree::Group LightTree::group_of(std::span<Entry> entries) {
    Group group{entries, {}};
    for (const Entry& entry : entries) {
        group.bounds = group.bounds.with(entry.bounds);
    }
    return group;
}

void LightTree::add(const Group& group, const Entry* first, std::int32_t parent) {
    // Wider by more than the rounding of kernels.
    constexpr float kMargin = 1e-4f;
    constexpr float kReachMargin = 1e-3f;  // by which the cosine of a reach of 0 differs from 1
    const LightBounds& bounds = group.bounds;
    const V3f centre = bounds.box.center();
    const float spread = std::min(kPi, bounds.spread + kMargin);
    const float reach = std::min(kPi, bounds.reach + kReachMargin);
    const std::array<float, LightTreeData::kNumbers> numbers{
        centre.x,          centre.y,
        centre.z,          0.5f * (1 + kMargin) * bounds.box.size().length(),
        bounds.strength,   bounds.axis.x,
        bounds.axis.y,     bounds.axis.z,
        cosine_of(spread), std::max(0.0f, sine_of(spread)),
        cosine_of(reach)};
    numbers_.insert(numbers_.end(), numbers.begin(), numbers.end());
    first_child_.push_back(-1);
    children_.push_back(0);
    const auto begin = static_cast<std::int32_t>(group.entries.data() - first);
    first_light_.push_back(begin);
    last_light_.push_back(begin + static_cast<std::int32_t>(group.entries.size()));
    parents_.push_back(parent);
}

std::pair<LightTree::Group, LightTree::Group> LightTree::halves(const Group& group) {
    const std::span<Entry> entries = group.entries;
    Imath::Box3f centres;
    for (const Entry& entry : entries) {
        centres.extendBy(entry.bounds.box.center());
    }
    const V3f extent = group.bounds.box.size();
    const float longest = std::max({extent.x, extent.y, extent.z});
    Split split{INFINITY, -1, 0};
    for (int axis = 0; axis < 3; ++axis) {
        Split found = best_split(entries, centres, axis);
        // Against slivers, as in section 4.4 of the paper.
        found.cost *= longest / extent[axis];
        split = found.cost < split.cost ? found : split;
    }
    std::size_t middle = entries.size() / 2;
    if (split.axis >= 0) {
        const auto parted =
            std::stable_partition(entries.begin(), entries.end(), [&](const Entry& entry) {
                return entry.bounds.box.center()[split.axis] < split.below;
            });
        // Rounding may put all of them to one side.
        const auto left = static_cast<std::size_t>(parted - entries.begin());
        middle = left > 0 && left < entries.size() ? left : middle;
    }
    return {group_of(entries.first(middle)), group_of(entries.subspan(middle))};
}

void LightTree::build(std::size_t node, const Group& group, const Entry* first,
                      std::size_t most_children) {
    if (group.entries.size() == 1) {
        const std::int32_t light = group.entries.front().light;
        leaf_of_light_[static_cast<std::size_t>(light)] = static_cast<std::int32_t>(node);
        return;
    }
    // Of large and strong groups estimates say least.
    const auto vagueness = [](const Group& one) {
        return one.entries.size() == 1 ? -1.0F
                                       : one.bounds.box.size().length() * one.bounds.strength;
    };
    std::vector<Group> groups{group};
    while (groups.size() < most_children) {
        const auto vaguest = std::max_element(
            groups.begin(), groups.end(),
            [&](const Group& a, const Group& b) { return vagueness(a) < vagueness(b); });
        if (vaguest->entries.size() == 1) {
            break;
        }
        // In their order in space, so that neighbours are chosen by neighbouring numbers.
        auto [left, right] = halves(*vaguest);
        *vaguest = right;
        groups.insert(vaguest, left);
    }
    const std::size_t child = first_child_.size();
    first_child_[node] = static_cast<std::int32_t>(child);
    children_[node] = static_cast<std::int32_t>(groups.size());
    for (const Group& part : groups) {
        add(part, first, static_cast<std::int32_t>(node));
    }
    for (std::size_t i = 0; i < groups.size(); ++i) {
        build(child + i, groups[i], first, LightTreeData::kMostOfNode);
    }
}

LightTreeData LightTree::data() const {
    LightTreeData data{List<float>(numbers_),
                       List<std::int32_t>(first_child_),
                       List<std::int32_t>(children_),
                       List<std::int32_t>(first_light_),
                       List<std::int32_t>(last_light_),
                       List<std::int32_t>(parents_),
                       List<std::int32_t>(lights_),
                       List<float>(strength_before_),
                       List<std::int32_t>(leaf_of_light_)};
    data.shines_all_around = shines_all_around_;
    return data;
}

}  // namespace carom::render
