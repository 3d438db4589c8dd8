// The closed list of all variants.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

#include "lab/triangle/variant.h"

namespace carom::render::triangle {

struct KernelFacts {
    KernelName kernel;
    std::string_view name;
    std::string_view title;
    bool corners, corners_and_normal, record;  // the inputs that it has
    bool has_axis = false;                     // it projects triangles along an axis
    bool has_techniques = true;                // it exists with techniques other than the plain one
};

/// In the order of the enumeration. Point tests have no record, because nothing but a normal is
/// worth preparing for them; kernels whose idea is the record have nothing else. The last four are
/// the simple tests that texts on the subject begin with.
inline constexpr std::array kKernels = {
    KernelFacts{KernelName::moller_trumbore, "moller_trumbore", "Möller–Trumbore", true, false,
                true},
    KernelFacts{KernelName::kensler_shirley, "kensler_shirley", "Kensler–Shirley", true, true,
                true},
    KernelFacts{KernelName::shevtsov, "shevtsov", "Shevtsov–Soupikov–Kapustin", false, false, true,
                true},
    KernelFacts{KernelName::badouel, "badouel", "Badouel", false, true, true, true},
    KernelFacts{KernelName::wald, "wald", "Wald", false, false, true, true},
    KernelFacts{KernelName::keidy, "keidy", "Keidy", true, true, false},
    KernelFacts{KernelName::perpendicular_planes, "perpendicular_planes", "perpendicular planes",
                false, false, true},
    KernelFacts{KernelName::angle_sum, "angle_sum", "sum of angles", true, true, false, false,
                false},
    KernelFacts{KernelName::half_spaces, "half_spaces", "half-spaces", false, true, true, false,
                false},
    KernelFacts{KernelName::origin_half_spaces, "origin_half_spaces", "half-spaces at the origin",
                true, true, false, false, false},
    KernelFacts{KernelName::signed_areas, "signed_areas", "signed areas", true, true, false, false,
                false}};
inline constexpr int kKernelCount = static_cast<int>(kKernels.size());

[[nodiscard]] constexpr const KernelFacts& facts(KernelName kernel) {
    return kKernels[static_cast<std::size_t>(kernel)];
}
static_assert([] {
    for (int i = 0; i < kKernelCount; ++i) {
        if (facts(static_cast<KernelName>(i)).kernel != static_cast<KernelName>(i)) {
            return false;
        }
    }
    return true;
}());

[[nodiscard]] constexpr bool has_input(KernelName kernel, Input input) {
    const KernelFacts& of = facts(kernel);
    return input == Input::corners              ? of.corners
           : input == Input::corners_and_normal ? of.corners_and_normal
                                                : of.record;
}

/// The input with which the least is left to do in a test.
[[nodiscard]] constexpr Input best_input(KernelName kernel) {
    return facts(kernel).record               ? Input::record
           : facts(kernel).corners_and_normal ? Input::corners_and_normal
                                              : Input::corners;
}

[[nodiscard]] constexpr bool is_several_rays(Packing packing) {
    return packing == Packing::four_rays || packing == Packing::eight_rays;
}

[[nodiscard]] constexpr bool is_several_triangles(Packing packing) {
    return packing == Packing::four_triangles || packing == Packing::eight_triangles;
}

/// Techniques are for the best input, in float. Where a technique does not concern the division, it
/// exists with the early one.
[[nodiscard]] constexpr bool exists(const Variant& variant) {
    const KernelFacts& kernel = facts(variant.form.kernel);
    if (!has_input(kernel.kernel, variant.form.input)) {
        return false;
    }
    if (variant.technique == Technique::plain) {
        return true;
    }
    if (!kernel.has_techniques || variant.form.input != best_input(kernel.kernel) ||
        variant.precision != Precision::single_precision) {
        return false;
    }
    const bool is_early = variant.form.division == Division::early;
    switch (variant.technique) {
        case Technique::plain:
        case Technique::newton:
            return true;
        case Technique::arrays:
            return is_early;
        case Technique::structures:
            return is_early && variant.packing != Packing::single;
        case Technique::sign_bits:
            return !is_early;
        case Technique::axis_from_table:
        case Technique::axis_by_versions:
        case Technique::axis_by_order:
            return is_early && kernel.has_axis && !is_several_triangles(variant.packing);
        case Technique::axis_fixed:
            return is_early && kernel.has_axis;
        case Technique::any_hit:
            return is_early;
        case Technique::common_origin:
        case Technique::parallel_rays:
            return is_early && is_several_rays(variant.packing);
    }
    return false;
}

/// Calls `visit` with all variants, kernel by kernel, then by input, division, precision, packing
/// and technique.
template <class Visit>
constexpr void for_each_variant(const Visit& visit) {
    for (const KernelFacts& kernel : kKernels) {
        for (const Input input : kInputs) {
            for (const Division division : kDivisions) {
                for (const Precision precision : kPrecisions) {
                    for (const Packing packing : kPackings) {
                        for (const Technique technique : kTechniques) {
                            const Variant variant{
                                {kernel.kernel, input, division}, packing, precision, technique};
                            if (exists(variant)) {
                                visit(variant);
                            }
                        }
                    }
                }
            }
        }
    }
}

/// The variants for which kIsOne is true.
template <bool (*kIsOne)(const Variant&)>
inline constexpr auto kVariantsWith = [] {
    constexpr std::size_t kCount = [] {
        std::size_t count = 0;
        for_each_variant([&](const Variant& variant) { count += kIsOne(variant) ? 1 : 0; });
        return count;
    }();
    std::array<Variant, kCount> variants;
    std::size_t next = 0;
    for_each_variant([&](const Variant& variant) {
        if (kIsOne(variant)) {
            variants[next++] = variant;
        }
    });
    return variants;
}();

/// All forms, in the order of the variants.
[[nodiscard]] std::span<const Form> all_forms();

}  // namespace carom::render::triangle
