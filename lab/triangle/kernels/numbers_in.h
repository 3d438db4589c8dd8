/// References to the numbers of single values and triples, one after another: for
/// Record::numbers().
template <class Part>
auto numbers_of_part(Part& part) {
    if constexpr (requires { part.z; }) {
        return std::tie(part.x, part.y, part.z);
    } else {
        return std::tie(part);
    }
}
template <class... Parts>
auto numbers_in(Parts&... parts) {
    return std::tuple_cat(numbers_of_part(parts)...);
}

/// The record of kernels that prepare nothing but the edges from a corner and a normal.
struct EdgesAndNormal {
    template <class L>
    struct Record {
        static constexpr bool kHasAxis = false;
        Vec3<typename L::Value> a, edge_b, edge_c, normal;

        template <class Self>
        [[nodiscard]] static auto numbers(Self& self) {
            return numbers_in(self.a, self.edge_b, self.edge_c, self.normal);
        }
    };

    template <class L>
    CAROM_KERNEL static Record<L> prepare(const Corners<L>& corners) {
        return prepare(CornersAndNormal<L>{corners, normal_of(corners)});
    }
    template <class L>
    CAROM_KERNEL static Record<L> prepare(const CornersAndNormal<L>& input) {
        const Corners<L>& corners = input.corners;
        return {corners.a, corners.b - corners.a, corners.c - corners.a, input.normal};
    }
};
