/// The kernels' types, in the order of their names.
using KernelTypes =
    std::tuple<MollerTrumbore, KenslerShirley, ShevtsovSoupikovKapustin, Badouel, Wald, Keidy,
               PerpendicularPlanes, AngleSum, HalfSpaces, OriginHalfSpaces, SignedAreas>;
static_assert(std::tuple_size_v<KernelTypes> == kKernelCount);
template <KernelName kName>
using KernelOf = std::tuple_element_t<static_cast<std::size_t>(kName), KernelTypes>;

/// A kernel's view of each input.
template <class Kernel, Input kInput, class L>
struct InputChoice {
    using Type = typename Kernel::template Record<L>;
};
template <class Kernel, class L>
struct InputChoice<Kernel, Input::corners, L> {
    using Type = Corners<L>;
};
template <class Kernel, class L>
struct InputChoice<Kernel, Input::corners_and_normal, L> {
    using Type = CornersAndNormal<L>;
};
template <class Kernel, Input kInput, class L>
using InputOf = typename InputChoice<Kernel, kInput, L>::Type;

template <class Kernel, class L>
CAROM_KERNEL const typename Kernel::template Record<L>& record_of(
    const typename Kernel::template Record<L>& record) {
    return record;
}
template <class Kernel, class L>
CAROM_KERNEL typename Kernel::template Record<L> record_of(const Corners<L>& input) {
    return Kernel::prepare(input);
}
template <class Kernel, class L>
CAROM_KERNEL typename Kernel::template Record<L> record_of(const CornersAndNormal<L>& input) {
    return Kernel::prepare(input);
}

/// The numbers of an input.
template <class Input>
using NumberIndices =
    std::make_index_sequence<std::tuple_size_v<decltype(Input::numbers(std::declval<Input&>()))>>;

template <class T>
Vec3<T> triple(const V3f& v) {
    return {v.x, v.y, v.z};
}

/// A triangle of a set as an input, computed in the lane type L.
template <class Kernel, Input kInput, class L>
InputOf<Kernel, kInput, L> make_input(const TriangleCorners& triangle) {
    using T = typename L::Number;
    const Corners<L> corners{triple<T>(triangle.a), triple<T>(triangle.b), triple<T>(triangle.c)};
    if constexpr (kInput == Input::corners) {
        return corners;
    } else if constexpr (kInput == Input::corners_and_normal) {
        return {corners, normal_of(corners)};
    } else {
        return Kernel::prepare(corners);
    }
}
