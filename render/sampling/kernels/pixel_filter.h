// Pixel filters in lanes. Included as render/lanes/kernels/vectors.h is.

/// Offset from the pixel's centre along one axis, pixels; at most half the filter's width.
template <class L>
CAROM_KERNEL ValueOf<L> filter_offset(const PixelFilterTables& filter, ValueOf<L> u) {
    if (filter.cells == nullptr) {
        return (u - L::all(0.5f)) * L::all(filter.width);
    }
    auto at =
        L::gather_int(filter.guide, L::to_int(u * L::all(static_cast<float>(filter.guide_count))));
    const auto numbers = [&](int which) CAROM_KERNEL_ATTRIBUTE {
        return L::gather_pair(filter.cells + which, at + at + at);
    };
    auto slope_and_next_cdf = numbers(2);
    for (;;) {
        const auto goes_on = L::is_at_most(slope_and_next_cdf.second, u);
        if (L::none(goes_on)) {
            break;
        }
        at = at + L::select_int(goes_on, L::all_int(1), L::all_int(0));
        slope_and_next_cdf = numbers(2);
    }
    const auto cdf_and_start = numbers(0);
    return cdf_and_start.second + slope_and_next_cdf.first * (u - cdf_and_start.first);
}
