// Rays against the boxes of a tree, in lanes. Included as render/lanes/kernels/vectors.h is.

/// Lines in the form that box tests need. Boxes are widened by a fraction of the origin's
/// coordinates, so that rounding never makes a box test miss what the test of a shape hits.
template <class L>
struct BoxLines {
    ValueOf<L> low[3], high[3];  // the origin before lower planes, and before upper ones
    ValueOf<L> inverse[3];       // of the direction
};

template <class L>
CAROM_KERNEL BoxLines<L> box_lines(const ValueOf<L> (&origin)[3],
                                   const ValueOf<L> (&direction)[3]) {
    const auto sum = L::size(origin[0]) + L::size(origin[1]) + L::size(origin[2]);
    const auto margin = sum * L::all(0x1p-18f);
    BoxLines<L> lines;
    for (int axis = 0; axis < 3; ++axis) {
        lines.low[axis] = origin[axis] + margin;
        lines.high[axis] = origin[axis] - margin;
        lines.inverse[axis] = finite_reciprocal<L>(direction[axis]);
    }
    return lines;
}

/// Where rays enter and leave a box.
template <class L>
struct PassageOf {
    ValueOf<L> enter, leave;
};

/// `planes`: by axis, low and high. Not cut at the rays' ends.
template <class L>
CAROM_KERNEL PassageOf<L> passage(const float (&planes)[3][2], const BoxLines<L>& lines) {
    ValueOf<L> near[3];
    ValueOf<L> far[3];
    for (int axis = 0; axis < 3; ++axis) {
        const auto a = (L::all(planes[axis][0]) - lines.low[axis]) * lines.inverse[axis];
        const auto b = (L::all(planes[axis][1]) - lines.high[axis]) * lines.inverse[axis];
        near[axis] = L::smaller(a, b);
        far[axis] = L::larger(a, b);
    }
    return {L::larger(L::larger(near[0], near[1]), near[2]),
            L::smaller(L::smaller(far[0], far[1]), far[2])};
}
