// Pixel filters in lanes. Included as render/lanes/kernels/vectors.h is.

/// See PixelFilterSampler::sample: the offset along one axis, pixels.
template <class L>
CAROM_KERNEL typename L::Value filter_offset(const PixelFilterTables& filter, typename L::Value u) {
    if (filter.cells == nullptr) {
        return (u - L::all(0.5f)) * L::all(filter.width);
    }
    auto at =
        L::gather_int(filter.guide, L::to_int(u * L::all(static_cast<float>(filter.guide_count))));
    const auto number = [&](int which) CAROM_KERNEL_ATTRIBUTE {
        return L::gather(filter.cells + which, at + at + at);
    };
    for (;;) {
        const auto goes_on = L::is_at_most(number(3), u);  // the next cell's cdf
        if (L::none(goes_on)) {
            break;
        }
        at = at + L::select_int(goes_on, L::all_int(1), L::all_int(0));
    }
    return number(1) + number(2) * (u - number(0));
}
