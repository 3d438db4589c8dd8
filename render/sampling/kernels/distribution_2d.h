// Sampling of distribution_2d.h's tables in lanes. Included as render/lanes/kernels/vectors.h is.

template <class L>
struct CellOf {
    IntOf<L> index;
    ValueOf<L> within;  // [0, 1)
};

/// The cell whose interval of a cumulative distribution contains u. The distribution has `count` +
/// 1 numbers from `first` on, and its cuts are `count` numbers from `first_cut` on.
template <class L>
CAROM_KERNEL CellOf<L> find_cell(const float* cdf, IntOf<L> first, const std::uint16_t* cuts,
                                 IntOf<L> first_cut, int count, ValueOf<L> u) {
    const auto part =
        L::smaller_int(L::to_int(u * L::all(static_cast<float>(count))), L::all_int(count - 1));
    const auto one = L::all_int(1);
    const auto last = L::all_int(count - 1);
    // The cell lies between those in which this part and the next one begin. Both are in one word.
    const auto cut = first_cut + part;
    const auto both_cuts = L::gather_bytes(cuts, cut + cut);
    auto index = L::from_word(both_cuts & L::all_word(0xffffu));
    auto end = L::select_int(L::is_less_int(part, last),
                             L::from_word(L::template shifted_right<16>(both_cuts)), last);
    for (;;) {
        const auto is_open = L::is_less_int(index, end);
        if (L::none(is_open)) {
            break;
        }
        const auto middle = L::select_int(
            is_open, index + L::template shifted_right_int<1>(end - index + one), index);
        const auto is_below = L::is_at_most(L::gather(cdf, first + middle), u);
        index = L::select_int(L::both(is_open, is_below), middle, index);
        end = L::select_int(is_below, end, middle - one);
    }
    auto edges = L::gather_pair(cdf, first + index);
    for (;;) {
        const auto goes = L::both(L::is_less_int(index, last), L::is_at_most(edges.second, u));
        if (L::none(goes)) {
            break;
        }
        index = L::select_int(goes, index + one, index);
        edges = L::gather_pair(cdf, first + index);
    }
    // u times the number of parts may have been rounded up into the next part.
    for (;;) {
        const auto goes = L::both(L::is_less_int(L::all_int(0), index), L::is_less(u, edges.first));
        if (L::none(goes)) {
            break;
        }
        index = L::select_int(goes, index - one, index);
        edges = L::gather_pair(cdf, first + index);
    }
    const auto width = edges.second - edges.first;
    const auto exists = L::is_less(L::all(0), width);
    const auto within =
        L::select(exists, (u - edges.first) / L::select(exists, width, L::all(1)), L::all(0));
    return {index, L::smaller(within, L::all(kOneMinusEpsilon))};
}

template <class L>
CAROM_KERNEL ValueOf<L> coordinate_of(const CellOf<L>& cell, int count) {
    const auto place = L::to_value(cell.index) + cell.within;
    return L::smaller(place / L::all(static_cast<float>(count)), L::all(kOneMinusEpsilon));
}

template <class L>
struct UvSampleOf {
    Vec2Of<L> uv;    // [0, 1)^2: u along a row, v from the first row to the last
    ValueOf<L> pdf;  // per area of the unit square
};

/// A point in proportion to the weights. `tables` must have a density.
template <class L>
CAROM_KERNEL UvSampleOf<L> sample_piecewise_constant(const DistributionTables& tables,
                                                     const Vec2Of<L>& u) {
    const auto zero = L::all_int(0);
    const CellOf<L> row =
        find_cell<L>(tables.row_cdf.data(), zero, tables.row_cuts.data(), zero, tables.height, u.y);
    const auto first_cut = L::product(row.index, tables.width);
    const CellOf<L> column = find_cell<L>(tables.column_cdfs.data(), first_cut + row.index,
                                          tables.column_cuts.data(), first_cut, tables.width, u.x);
    return {{coordinate_of<L>(column, tables.width), coordinate_of<L>(row, tables.height)},
            L::gather(tables.density.data(), first_cut + column.index)};
}

/// Density of `sample_piecewise_constant` per area of the unit square; `uv` in [0, 1]^2.
template <class L>
CAROM_KERNEL ValueOf<L> pdf_piecewise_constant(const DistributionTables& tables,
                                               const Vec2Of<L>& uv) {
    const auto cell = [&](ValueOf<L> x, int count) CAROM_KERNEL_ATTRIBUTE {
        return L::smaller_int(L::to_int(x * L::all(static_cast<float>(count))),
                              L::all_int(count - 1));
    };
    const auto index =
        L::product(cell(uv.y, tables.height), tables.width) + cell(uv.x, tables.width);
    const auto is_inside = L::both(L::is_less(uv.x, L::all(1)), L::is_less(uv.y, L::all(1)));
    return L::select(is_inside, L::gather(tables.density.data(), index), L::all(0));
}
