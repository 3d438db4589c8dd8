// The choice of one of many lights, or of one of a light's faces, by a LightTree; in lanes.
// Included as render/lanes/kernels/vectors.h is.

/// The cosine of a - b, or 1 if b is larger; of angles in [0, pi].
template <class L>
CAROM_KERNEL ValueOf<L> cosine_of_rest(ValueOf<L> cosine_a, ValueOf<L> cosine_b,
                                       ValueOf<L> sine_b) {
    const auto sine_a = L::root(L::larger(L::all(0), L::all(1) - cosine_a * cosine_a));
    return L::select(L::is_less(cosine_b, cosine_a), L::all(1),
                     cosine_a * cosine_b + sine_a * sine_b);
}

/// What a tree has of nodes: all lanes the same one, or each its own.
template <class L>
struct SameNodeOf {
    const float* numbers;

    [[nodiscard]] CAROM_KERNEL ValueOf<L> number(int k) const { return L::all(numbers[k]); }
};
template <class L>
struct OwnNodeOf {
    const float* numbers;
    IntOf<L> first;

    [[nodiscard]] CAROM_KERNEL ValueOf<L> number(int k) const {
        return L::gather(numbers + k, first);
    }
};
template <class L>
CAROM_KERNEL SameNodeOf<L> same_node(const LightTreeData& tree, std::int32_t node) {
    return {tree.numbers.data() + std::int64_t{node} * LightTreeData::kNumbers};
}
template <class L>
CAROM_KERNEL OwnNodeOf<L> own_node(const LightTreeData& tree, IntOf<L> node) {
    return {tree.numbers.data(), L::product(node, LightTreeData::kNumbers)};
}

/// An estimate of the light that nodes give to surfaces, 0 only where nothing arrives (after Conty
/// Estevez and Kulla 2018, equation 3).
template <class L, class Node>
CAROM_KERNEL ValueOf<L> importance_of_node(const LightTreeData& tree, const Node& node,
                                           const Vec3Of<L>& point, const Vec3Of<L>& normal) {
    const auto zero = L::all(0);
    const auto one = L::all(1);
    const Vec3Of<L> to_node = Vec3Of<L>{node.number(0), node.number(1), node.number(2)} - point;
    const auto radius = node.number(3);
    const auto distance2 = L::larger(dot(to_node, to_node), L::all(1e-12f));
    const auto radius2 = radius * radius;
    const auto is_within = L::is_at_most(distance2, radius2);
    const auto distance = L::root(distance2);
    const auto sine = L::select(is_within, one, radius / distance);
    const auto cosine = L::root(L::larger(zero, one - sine * sine));
    // The mean over the node is between the largest cosine and that of its middle.
    const auto mean = [&](ValueOf<L> largest, ValueOf<L> middle) CAROM_KERNEL_ATTRIBUTE {
        return L::all(0.5f) * (L::select(is_within, one, L::larger(largest, L::all(1e-3f))) +
                               L::larger(middle, zero));
    };
    const auto to_surface = dot(to_node, normal) / distance;
    const auto at_surface = cosine_of_rest<L>(to_surface, cosine, sine);
    auto arrives = L::is_less(zero, at_surface);
    auto seen = mean(at_surface, to_surface);
    if (!tree.shines_all_around) {
        const Vec3Of<L> axis{node.number(5), node.number(6), node.number(7)};
        const auto from_normals = cosine_of_rest<L>(L::opposite_sign(dot(to_node, axis)) / distance,
                                                    node.number(8), node.number(9));
        const auto at_light = cosine_of_rest<L>(from_normals, cosine, sine);
        arrives = L::both(arrives, L::is_less(node.number(10), at_light));
        seen = seen * mean(at_light, from_normals);
    }
    // Around the middle of a node the mean of 1 / d^2 is six times that at its corners.
    const auto nearest2 = L::all(0.2f) * radius2;
    return L::select(L::either(is_within, arrives),
                     node.number(4) * seen / L::larger(distance2, nearest2), zero);
}

/// Whether nodes look so small that their lights differ by their strength alone.
template <class L>
CAROM_KERNEL MaskOf<L> looks_small(const OwnNodeOf<L>& node, const Vec3Of<L>& point) {
    constexpr float kSmall = 0.2f;  // radius over distance
    const Vec3Of<L> to_node = Vec3Of<L>{node.number(0), node.number(1), node.number(2)} - point;
    const auto radius = node.number(3);
    return L::is_less(radius * radius, L::all(kSmall * kSmall) * dot(to_node, to_node));
}

/// A tree seen from places: the importance of the root's children.
template <class L>
struct SeenTreeOf {
    Vec3Of<L> point, normal;
    ValueOf<L> total;
    ValueOf<L> importance[LightTreeData::kMostOfRoot];
};

/// `total` is 0 if the tree does not exist.
template <class L>
CAROM_KERNEL SeenTreeOf<L> see_tree(const LightTreeData& tree, const Vec3Of<L>& point,
                                    const Vec3Of<L>& normal) {
    SeenTreeOf<L> seen;
    seen.point = point;
    seen.normal = normal;
    seen.total = L::all(0);
    if (!tree.exists()) {
        return seen;
    }
    for (int i = 0; i < tree.choices_of_root(); ++i) {
        seen.importance[i] =
            importance_of_node<L>(tree, same_node<L>(tree, tree.first_choice() + i), point, normal);
        seen.total = seen.total + seen.importance[i];
    }
    return seen;
}

/// One of several in each lane, in proportion to importance, and the number that chose it, used
/// again.
template <class L>
struct OneOf {
    IntOf<L> index;
    ValueOf<L> probability;  // 0: none
    ValueOf<L> u;
};

template <class L>
CAROM_KERNEL OneOf<L> choose_one(const ValueOf<L>* importance, int count, ValueOf<L> total,
                                 ValueOf<L> u) {
    const auto zero = L::all(0);
    const auto place = u * total;
    auto low = zero;
    auto end = zero;
    auto width = zero;
    auto index = L::all_int(0);
    for (int i = 0; i < count; ++i) {
        // The last one with importance that begins at or before the place.
        const auto takes = L::both(L::is_at_most(end, place), L::is_less(zero, importance[i]));
        low = L::select(takes, end, low);
        width = L::select(takes, importance[i], width);
        index = L::select_int(takes, L::all_int(i), index);
        end = end + importance[i];
    }
    const auto exists = L::is_less(zero, width);
    return {index, L::select(exists, width / total, zero),
            limited<L>((place - low) / L::select(exists, width, L::all(1)), 0, kOneMinusEpsilon)};
}

/// A light in each lane. `u`: the number that chose it, used again.
template <class L>
struct TreeChoiceOf {
    IntOf<L> light;
    ValueOf<L> probability;  // 0: none
    ValueOf<L> u;
};

/// The first place in [first, last] at which a list that grows has a number above x, which the one
/// at `last` is or counts as; by bisection.
template <class L>
CAROM_KERNEL IntOf<L> first_above(const List<float>& numbers, IntOf<L> first, IntOf<L> last,
                                  ValueOf<L> x) {
    for (;;) {
        const auto is_open = L::is_less_int(first, last);
        if (L::none(is_open)) {
            return first;
        }
        const auto middle = first + L::template shifted_right_int<1>(last - first);
        const auto is_above = L::is_less(x, L::gather(numbers.data(), middle));
        last = L::select_int(L::both(is_open, is_above), middle, last);
        first =
            L::select_int(L::both(is_open, L::opposite(is_above)), middle + L::all_int(1), first);
    }
}

/// One of the lights of each lane's node, by their strength.
template <class L>
CAROM_KERNEL OneOf<L> choose_by_strength(const LightTreeData& tree, IntOf<L> node, ValueOf<L> u) {
    const auto strength_before = [&](IntOf<L> place) CAROM_KERNEL_ATTRIBUTE {
        return L::gather(tree.strength_before.data(), place);
    };
    const auto first = L::gather_int(tree.first_light.data(), node);
    const auto last = L::gather_int(tree.last_light.data(), node);
    const auto begin = strength_before(first);
    const auto all = strength_before(last) - begin;
    const auto x = begin + u * all;
    const auto place =
        first_above<L>(tree.strength_before, first + L::all_int(1), last, x) - L::all_int(1);
    const auto before = strength_before(place);
    const auto own = strength_before(place + L::all_int(1)) - before;
    const auto exists = L::is_less(L::all(0), own);
    return {place, L::select(exists, own / all, L::all(0)),
            limited<L>((x - before) / L::select(exists, own, L::all(1)), 0, kOneMinusEpsilon)};
}

/// The importance of the children of each lane's node.
template <class L>
struct SeenChildrenOf {
    ValueOf<L> importance[LightTreeData::kMostOfNode];
    ValueOf<L> total;
    int most = 0;  // children of a node
};

/// In the lanes `asks`; elsewhere there are none.
template <class L>
CAROM_KERNEL SeenChildrenOf<L> see_children(const LightTreeData& tree, const SeenTreeOf<L>& seen,
                                            IntOf<L> node, MaskOf<L> asks) {
    const auto first = L::gather_int(tree.first_child.data(), node);
    const auto count = L::gather_int(tree.children.data(), node);
    SeenChildrenOf<L> children;
    children.total = L::all(0);
    for (; children.most < LightTreeData::kMostOfNode; ++children.most) {
        const auto exists = L::both(asks, L::is_less_int(L::all_int(children.most), count));
        if (L::none(exists)) {
            break;
        }
        const auto child = L::select_int(exists, first + L::all_int(children.most), L::all_int(0));
        const auto importance =
            importance_of_node<L>(tree, own_node<L>(tree, child), seen.point, seen.normal);
        children.importance[children.most] = L::select(exists, importance, L::all(0));
        children.total = children.total + children.importance[children.most];
    }
    return children;
}

template <class L>
CAROM_KERNEL TreeChoiceOf<L> choose_in_tree(const LightTreeData& tree, const SeenTreeOf<L>& seen,
                                            ValueOf<L> u) {
    const auto zero = L::all(0);
    const auto none = L::all_int(0);
    OneOf<L> one = choose_one<L>(seen.importance, tree.choices_of_root(), seen.total, u);
    auto probability = one.probability;
    auto node = L::all_int(tree.first_choice()) + one.index;
    u = one.u;
    for (;;) {
        const OwnNodeOf<L> own = own_node<L>(tree, node);
        const auto first = L::gather_int(tree.first_child.data(), node);
        const auto goes_on =
            L::without(L::both(L::is_less_int(none, first), L::is_less(zero, probability)),
                       looks_small<L>(own, seen.point));
        if (L::none(goes_on)) {
            break;
        }
        const SeenChildrenOf<L> children = see_children<L>(tree, seen, node, goes_on);
        one = choose_one<L>(children.importance, children.most, children.total, u);
        u = L::select(goes_on, one.u, u);
        probability = L::select(goes_on, probability * one.probability, probability);
        node = L::select_int(goes_on, first + one.index, node);
    }
    one = choose_by_strength<L>(tree, node, u);
    return {L::gather_int(tree.lights.data(), one.index), probability * one.probability, one.u};
}

/// The probability of being chosen.
template <class L>
CAROM_KERNEL ValueOf<L> chance_in_tree(const LightTreeData& tree, const SeenTreeOf<L>& seen,
                                       IntOf<L> light) {
    const auto zero = L::all(0);
    const auto none = L::all_int(0);
    const auto leaf = L::gather_int(tree.leaf_of_light.data(), light);
    const auto is_chosen =
        L::both(L::is_less_int(L::all_int(-1), leaf), L::is_less(zero, seen.total));
    const auto strength_of = [&](IntOf<L> of) CAROM_KERNEL_ATTRIBUTE {
        return L::gather(tree.strength_before.data(), L::gather_int(tree.last_light.data(), of)) -
               L::gather(tree.strength_before.data(), L::gather_int(tree.first_light.data(), of));
    };
    auto node = L::larger_int(leaf, none);
    const auto strength = strength_of(node);
    auto probability = L::all(1);
    for (;;) {
        const OwnNodeOf<L> own = own_node<L>(tree, node);
        // In what looks small the choice is by strength, whatever is below.
        probability =
            L::select(looks_small<L>(own, seen.point), strength / strength_of(node), probability);
        const auto importance = importance_of_node<L>(tree, own, seen.point, seen.normal);
        const auto parent = L::gather_int(tree.parents.data(), node);
        const auto is_low = L::is_less_int(none, parent);
        if (L::none(is_low)) {
            return L::select(is_chosen, probability * importance / seen.total, zero);
        }
        const auto total = see_children<L>(tree, seen, L::larger_int(parent, none), is_low).total;
        const auto is_seen = L::both(is_low, L::is_less(zero, importance));
        const auto share =
            L::select(is_seen, importance / L::select(is_seen, total, L::all(1)), zero);
        probability = L::select(is_low, probability * share, probability);
        node = L::select_int(is_low, parent, node);
    }
}
