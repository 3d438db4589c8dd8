// How a test finds the coordinates along a triangle's projection axis w and along the two axes that
// follow it (x, y, z, x). Without a call of the vectors' operators, whose code may be for one
// instruction set only.
#pragma once

#include <cstdint>

#include "lab/triangle/variant.h"

namespace carom::render::triangle {

/// The coordinates of x along an axis w and along the two that follow it. Choice::index(axis, k):
/// the index of the k-th axis from w on.
template <class Choice>
struct CoordinatesBy {
    template <class Vector, class Axis>
    [[gnu::always_inline]] static const auto& along(const Vector& x, const Axis& axis) {
        return (&x.x)[Choice::index(axis, 0)];
    }
    template <class Vector, class Axis>
    [[gnu::always_inline]] static const auto& after(const Vector& x, const Axis& axis) {
        return (&x.x)[Choice::index(axis, 1)];
    }
    template <class Vector, class Axis>
    [[gnu::always_inline]] static const auto& before(const Vector& x, const Axis& axis) {
        return (&x.x)[Choice::index(axis, 2)];
    }
};

/// All three indices are in the record, because tests wait for them.
struct StoredAxes : CoordinatesBy<StoredAxes> {
    struct Axis {
        std::uint32_t w, u, v;
    };
    [[nodiscard]] static constexpr Axis axis(unsigned w) { return {w, (w + 1) % 3, (w + 2) % 3}; }
    [[gnu::always_inline]] static std::uint32_t index(const Axis& axis, unsigned k) {
        return k == 0 ? axis.w : (k == 1 ? axis.u : axis.v);
    }
};

/// The record has w; a table has the axes that follow.
struct AxisFromTable : CoordinatesBy<AxisFromTable> {
    struct Axis {
        std::uint32_t w;
    };
    static constexpr std::uint32_t kAfter[3] = {1, 2, 0};
    static constexpr std::uint32_t kBefore[3] = {2, 0, 1};

    [[nodiscard]] static constexpr Axis axis(unsigned w) { return {w}; }
    [[gnu::always_inline]] static std::uint32_t index(const Axis& axis, unsigned k) {
        return k == 0 ? axis.w : (k == 1 ? kAfter : kBefore)[axis.w];
    }
};

/// The axis is known when the code is compiled.
template <unsigned kW>
struct FixedAxis : CoordinatesBy<FixedAxis<kW>> {
    struct Axis {};

    [[nodiscard]] static constexpr Axis axis(unsigned) { return {}; }
    [[gnu::always_inline]] static std::uint32_t index(const Axis& /*axis*/, unsigned k) {
        return (kW + k) % 3;
    }
};

template <Technique kTechnique>
struct AxisChoice {
    using Type = StoredAxes;
};
template <>
struct AxisChoice<Technique::axis_from_table> {
    using Type = AxisFromTable;
};
/// The version is chosen by w.
template <>
struct AxisChoice<Technique::axis_by_versions> {
    using Type = AxisFromTable;
};
template <>
struct AxisChoice<Technique::axis_by_order> {
    using Type = FixedAxis<0>;
};
template <>
struct AxisChoice<Technique::axis_fixed> {
    using Type = FixedAxis<2>;
};
template <Technique kTechnique>
using AxisChoiceOf = typename AxisChoice<kTechnique>::Type;

}  // namespace carom::render::triangle
