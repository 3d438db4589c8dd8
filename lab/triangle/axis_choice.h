// How a test finds the coordinates along a triangle's projection axis w and along the two axes that
// follow it (x, y, z, x). Without a call of the vectors' operators, whose code may be for one
// instruction set only.
#pragma once

#include <cstdint>

#include "lab/triangle/variant.h"

namespace carom::render::triangle {

/// All three indices are in the record, because tests wait for them.
struct StoredAxes {
    struct Axis {
        std::uint32_t w, u, v;
    };
    static constexpr Axis kOrders[3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}};

    [[nodiscard]] static constexpr Axis axis(unsigned w) { return kOrders[w]; }
    template <class Vector>
    [[gnu::always_inline]] static const auto& along(const Vector& x, const Axis& axis) {
        return (&x.x)[axis.w];
    }
    template <class Vector>
    [[gnu::always_inline]] static const auto& after(const Vector& x, const Axis& axis) {
        return (&x.x)[axis.u];
    }
    template <class Vector>
    [[gnu::always_inline]] static const auto& before(const Vector& x, const Axis& axis) {
        return (&x.x)[axis.v];
    }
};

/// The record has w; a table has the axes that follow.
struct AxisFromTable {
    struct Axis {
        std::uint32_t w;
    };
    static constexpr std::uint32_t kAfter[3] = {1, 2, 0};
    static constexpr std::uint32_t kBefore[3] = {2, 0, 1};

    [[nodiscard]] static constexpr Axis axis(unsigned w) { return {w}; }
    template <class Vector>
    [[gnu::always_inline]] static const auto& along(const Vector& x, const Axis& axis) {
        return (&x.x)[axis.w];
    }
    template <class Vector>
    [[gnu::always_inline]] static const auto& after(const Vector& x, const Axis& axis) {
        return (&x.x)[kAfter[axis.w]];
    }
    template <class Vector>
    [[gnu::always_inline]] static const auto& before(const Vector& x, const Axis& axis) {
        return (&x.x)[kBefore[axis.w]];
    }
};

/// The axis is known when the code is compiled.
template <unsigned kW>
struct FixedAxis {
    struct Axis {};

    [[nodiscard]] static constexpr Axis axis(unsigned) { return {}; }
    template <class Vector>
    [[gnu::always_inline]] static const auto& along(const Vector& x, const Axis&) {
        return (&x.x)[kW];
    }
    template <class Vector>
    [[gnu::always_inline]] static const auto& after(const Vector& x, const Axis&) {
        return (&x.x)[(kW + 1) % 3];
    }
    template <class Vector>
    [[gnu::always_inline]] static const auto& before(const Vector& x, const Axis&) {
        return (&x.x)[(kW + 2) % 3];
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
