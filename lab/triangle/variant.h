// The kernels by name, and the forms in which each can run.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lab/triangle/scalar_lanes.h"

namespace carom::render::triangle {

enum class KernelName {
    moller_trumbore,
    kensler_shirley,
    shevtsov,
    badouel,
    wald,
    keidy,
    perpendicular_planes
};
inline constexpr int kKernelCount = 7;

/// The input of a test: the corners, the corners with a normal that exists for other reasons, or a
/// record prepared when the scene is set up.
enum class Input { corners, corners_and_normal, record };

/// The number of tests at a time.
enum class Packing { single, four_rays, eight_rays, four_triangles, eight_triangles };
inline constexpr std::array kPackings = {Packing::single, Packing::four_rays, Packing::eight_rays,
                                         Packing::four_triangles, Packing::eight_triangles};

enum class Precision { single_precision, double_precision };

/// A kernel with one of its inputs, and one of the two places of its division.
struct Form {
    KernelName kernel = KernelName::moller_trumbore;
    Input input = Input::corners;
    Division division = Division::early;

    friend bool operator==(const Form&, const Form&) = default;
};

/// A form with its precision and packing.
struct Variant {
    Form form;
    Packing packing = Packing::single;
    Precision precision = Precision::single_precision;

    friend bool operator==(const Variant&, const Variant&) = default;
};

/// All forms, kernel by kernel in the order of the enumeration. Point tests (Keidy) have no record;
/// kernels whose idea is the record (Shevtsov, Wald, perpendicular planes) have nothing else.
[[nodiscard]] std::span<const Form> all_forms();

/// For display: "Möller–Trumbore". For options and data: "moller_trumbore", "corners", "deferred",
/// "eight_rays", "float".
[[nodiscard]] std::string_view title(KernelName kernel);
[[nodiscard]] std::string_view name(KernelName kernel);
[[nodiscard]] std::string_view name(Input input);
[[nodiscard]] std::string_view name(Division division);
[[nodiscard]] std::string_view name(Packing packing);
[[nodiscard]] std::string_view name(Precision precision);

/// Empty if the name is unknown.
[[nodiscard]] std::optional<KernelName> find_kernel(std::string_view name);

}  // namespace carom::render::triangle
