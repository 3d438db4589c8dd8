/// Begins a record for projection along the axis w of the normal's largest component: w, and the
/// plane x_w + normal_u x_u + normal_v x_v = plane, with the normal scaled so that its component
/// along w is 1. Returns the scale.
template <class L, class Record>
CAROM_KERNEL typename L::Value set_axis_and_plane(const Corners<L>& corners, Record& record) {
    const auto normal = normal_of(corners);
    const auto& a = corners.a;
    const auto w = L::longest_axis(normal);
    const auto scale = L::all(1) / L::along(normal, w);
    record.axis = w;
    record.normal_u = L::after(normal, w) * scale;
    record.normal_v = L::before(normal, w) * scale;
    record.plane =
        record.normal_u * L::after(a, w) + record.normal_v * L::before(a, w) + L::along(a, w);
    return scale;
}
