// How the lobes of a path's vertex are followed, in lanes. Included as
// render/lanes/kernels/vectors.h is.

template <class L>
struct SplittingOf {
    MaskOf<L> splits;       // the coat and the base are followed separately
    MaskOf<L> shows_gloss;  // ... and the coat in several directions
    bool any_gloss;         // false: in no lane
};

/// The camera sees vertex 0. Of the vertices of one path, those before `split_vertices` split; at
/// the first one a rough coat takes `glossy_samples` directions.
template <class L>
CAROM_KERNEL SplittingOf<L> splitting_at(int vertex, int split_vertices, int glossy_samples,
                                         MaskOf<L> has_coat, MaskOf<L> has_rough_coat) {
    const auto none = L::is_less(L::all(0), L::all(0));
    const auto splits = vertex < split_vertices ? has_coat : none;
    const auto shows_gloss =
        vertex == 0 && glossy_samples > 1 ? L::both(splits, has_rough_coat) : none;
    return {splits, shows_gloss, !L::none(shows_gloss)};
}
