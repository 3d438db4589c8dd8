/// Calls make.operator()<Kernel, kInput, kDivision>() for a form; null if the form does not exist.
template <class Kernel, Input kInput, class Make>
std::unique_ptr<KernelRun> with_division(Division division, const Make& make) {
    if (division == Division::early) {
        return make.template operator()<Kernel, kInput, Division::early>();
    }
    return make.template operator()<Kernel, kInput, Division::deferred>();
}

template <class Kernel, Input kFirst, Input... kOthers, class Make>
std::unique_ptr<KernelRun> with_input(const Form& form, const Make& make) {
    if (form.input == kFirst) {
        return with_division<Kernel, kFirst>(form.division, make);
    }
    if constexpr (sizeof...(kOthers) > 0) {
        return with_input<Kernel, kOthers...>(form, make);
    } else {
        return nullptr;
    }
}

template <class Make>
std::unique_ptr<KernelRun> with_form(const Form& form, const Make& make) {
    using enum Input;
    switch (form.kernel) {
        case KernelName::moller_trumbore:
            return with_input<MollerTrumbore, corners, record>(form, make);
        case KernelName::kensler_shirley:
            return with_input<KenslerShirley, corners, corners_and_normal, record>(form, make);
        case KernelName::shevtsov:
            return with_input<ShevtsovSoupikovKapustin, record>(form, make);
        case KernelName::badouel:
            return with_input<Badouel, corners_and_normal, record>(form, make);
        case KernelName::wald:
            return with_input<Wald, record>(form, make);
        case KernelName::keidy:
            return with_input<Keidy, corners, corners_and_normal>(form, make);
        case KernelName::perpendicular_planes:
            return with_input<PerpendicularPlanes, record>(form, make);
    }
    return nullptr;
}

/// A run of this class template in a form; kCount: empty, or the number that a vector run takes at
/// once.
template <template <class, Input, Division, class, int...> class Run, class T, int... kCount>
std::unique_ptr<KernelRun> make_in_form(const Form& form, const TestSet& set) {
    return with_form(
        form, [&]<class Kernel, Input kInput, Division kDivision>() -> std::unique_ptr<KernelRun> {
            return std::make_unique<Run<Kernel, kInput, kDivision, T, kCount...>>(set);
        });
}

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

template <class T>
Triple<T> triple(const V3f& v) {
    return {{v.x, v.y, v.z}};
}

/// A triangle of a set as an input, computed in T.
template <class Kernel, Input kInput, class T>
InputOf<Kernel, kInput, ScalarLanes<T>> make_input(const TriangleCorners& triangle) {
    using L = ScalarLanes<T>;
    const Corners<L> corners{triple<T>(triangle.a), triple<T>(triangle.b), triple<T>(triangle.c)};
    if constexpr (kInput == Input::corners) {
        return corners;
    } else {
        const CornersAndNormal<L> with_normal{corners, normal_of(corners)};
        if constexpr (kInput == Input::corners_and_normal) {
            return with_normal;
        } else {
            return Kernel::prepare(corners);
        }
    }
}
