// The kernels by name, and the variants in which each can run.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "render/triangle/division.h"

namespace carom::render::triangle {

enum class KernelName {
    moller_trumbore,
    kensler_shirley,
    shevtsov,
    badouel,
    wald,
    keidy,
    perpendicular_planes,
    angle_sum,
    half_spaces,
    origin_half_spaces,
    signed_areas
};

/// The input of a test: the corners, the corners with a normal that exists for other reasons, or a
/// record prepared when the scene is set up.
enum class Input { corners, corners_and_normal, record };
inline constexpr std::array kInputs = {Input::corners, Input::corners_and_normal, Input::record};

inline constexpr std::array kDivisions = {Division::early, Division::deferred};

/// The number of tests at a time.
enum class Packing { single, four_rays, eight_rays, four_triangles, eight_triangles };
inline constexpr std::array kPackings = {Packing::single, Packing::four_rays, Packing::eight_rays,
                                         Packing::four_triangles, Packing::eight_triangles};

enum class Precision { single_precision, double_precision };
inline constexpr std::array kPrecisions = {Precision::single_precision,
                                           Precision::double_precision};

/// How a variant differs from the plain one. Plain are: rays and triangles in memory by groups of
/// as many as are tested at once, number by number (one by one: each triangle's numbers together);
/// division; floating-point comparisons; and, for kernels with an axis, a record with the indices
/// of all three axes (several triangles at once: a mask per lane).
enum class Technique {
    plain,
    arrays,            // one array for each number
    structures,        // the numbers of each ray or triangle side by side
    newton,            // an approximate reciprocal and one Newton step instead of the division
    sign_bits,         // integer operations on sign bits instead of comparisons
    axis_from_table,   // a record with one axis; a table has those that follow it
    axis_by_versions,  // three versions of the code, each for one axis
    axis_by_order,     // each triangle's coordinates begin with its axis; each ray in three orders
    axis_fixed,        // the same axis for all triangles
    any_hit,           // only whether a ray hits something: it ends at the first hit
    common_origin,     // rays of a group begin at one point: see shares_rays()
    parallel_rays      // rays of a group have one direction
};
inline constexpr std::array kTechniques = {Technique::plain,
                                           Technique::arrays,
                                           Technique::structures,
                                           Technique::newton,
                                           Technique::sign_bits,
                                           Technique::axis_from_table,
                                           Technique::axis_by_versions,
                                           Technique::axis_by_order,
                                           Technique::axis_fixed,
                                           Technique::any_hit,
                                           Technique::common_origin,
                                           Technique::parallel_rays};

/// Whether the rays of a group have something in common. They are tested triangle by triangle, so
/// that what depends on nothing else is computed once for each triangle.
[[nodiscard]] constexpr bool shares_rays(Technique technique) {
    return technique == Technique::common_origin || technique == Technique::parallel_rays;
}

/// A kernel with one of its inputs, and one of the two places of its division.
struct Form {
    KernelName kernel = KernelName::moller_trumbore;
    Input input = Input::corners;
    Division division = Division::early;

    friend bool operator==(const Form&, const Form&) = default;
};

/// A form with its packing, precision and technique.
struct Variant {
    Form form;
    Packing packing = Packing::single;
    Precision precision = Precision::single_precision;
    Technique technique = Technique::plain;

    friend bool operator==(const Variant&, const Variant&) = default;
};

/// For display: "Möller–Trumbore". For options and data: "moller_trumbore", "corners", "deferred",
/// "eight_rays", "float", "axis_fixed".
[[nodiscard]] std::string_view title(KernelName kernel);
[[nodiscard]] std::string_view name(KernelName kernel);
[[nodiscard]] std::string_view name(Input input);
[[nodiscard]] std::string_view name(Division division);
[[nodiscard]] std::string_view name(Packing packing);
[[nodiscard]] std::string_view name(Precision precision);
[[nodiscard]] std::string_view name(Technique technique);

/// Empty if the name is unknown.
[[nodiscard]] std::optional<KernelName> find_kernel(std::string_view name);
[[nodiscard]] std::optional<Technique> find_technique(std::string_view name);

}  // namespace carom::render::triangle
