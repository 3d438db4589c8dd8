// The kernels by name, and the variants in which each can run.
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <type_traits>

#include "render/triangle/division.h"

namespace carom::render::triangle {

/// A member of an enumeration with its name in options and data, and its title for display.
template <class Enum>
struct Named {
    Enum value;
    std::string_view name, title;
};

/// The members, in the order of their names.
template <class Enum, std::size_t kCount>
[[nodiscard]] constexpr std::array<Enum, kCount> values_of(
    const std::array<Named<Enum>, kCount>& names) {
    std::array<Enum, kCount> values{};
    std::ranges::transform(names, values.begin(), &Named<Enum>::value);
    return values;
}

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
inline constexpr std::array<Named<Input>, 3> kInputNames{
    {{Input::corners, "corners", "corners"},
     {Input::corners_and_normal, "corners_and_normal", "with normal"},
     {Input::record, "record", "record"}}};
inline constexpr auto kInputs = values_of(kInputNames);

inline constexpr std::array<Named<Division>, 2> kDivisionNames{
    {{Division::early, "early", "early"}, {Division::deferred, "deferred", "deferred"}}};
inline constexpr auto kDivisions = values_of(kDivisionNames);

/// The number of tests at a time.
enum class Packing { single, four_rays, eight_rays, four_triangles, eight_triangles };
inline constexpr std::array<Named<Packing>, 5> kPackingNames{
    {{Packing::single, "single", "one"},
     {Packing::four_rays, "four_rays", "4 rays"},
     {Packing::eight_rays, "eight_rays", "8 rays"},
     {Packing::four_triangles, "four_triangles", "4 triangles"},
     {Packing::eight_triangles, "eight_triangles", "8 triangles"}}};
inline constexpr auto kPackings = values_of(kPackingNames);

enum class Precision { single_precision, double_precision };
inline constexpr std::array<Named<Precision>, 2> kPrecisionNames{
    {{Precision::single_precision, "float", "float"},
     {Precision::double_precision, "double", "double"}}};
inline constexpr auto kPrecisions = values_of(kPrecisionNames);
template <Precision kPrecision>
using NumberOf = std::conditional_t<kPrecision == Precision::single_precision, float, double>;

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
inline constexpr std::array<Named<Technique>, 12> kTechniqueNames{
    {{Technique::plain, "plain", "plain"},
     {Technique::arrays, "arrays", "structure of arrays"},
     {Technique::structures, "structures", "array of structures"},
     {Technique::newton, "newton", "estimated reciprocal and a Newton step"},
     {Technique::sign_bits, "sign_bits", "tests of sign bits"},
     {Technique::axis_from_table, "axis_from_table", "following axes from a table"},
     {Technique::axis_by_versions, "axis_by_versions", "a version of the code for each axis"},
     {Technique::axis_by_order, "axis_by_order", "coordinates in the order of the axis"},
     {Technique::axis_fixed, "axis_fixed", "the same axis for all triangles"},
     {Technique::any_hit, "any_hit", "whether anything is hit"},
     {Technique::common_origin, "common_origin", "rays from one point"},
     {Technique::parallel_rays, "parallel_rays", "parallel rays"}}};
inline constexpr auto kTechniques = values_of(kTechniqueNames);

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

/// For options and data: "moller_trumbore", "corners", "deferred", "eight_rays", "float",
/// "axis_fixed".
[[nodiscard]] std::string_view name(KernelName kernel);
[[nodiscard]] std::string_view name(Input input);
[[nodiscard]] std::string_view name(Division division);
[[nodiscard]] std::string_view name(Packing packing);
[[nodiscard]] std::string_view name(Precision precision);
[[nodiscard]] std::string_view name(Technique technique);

/// For display: "Möller–Trumbore", "with normal", "8 triangles", "structure of arrays".
[[nodiscard]] std::string_view title(KernelName kernel);
[[nodiscard]] std::string_view title(Input input);
[[nodiscard]] std::string_view title(Packing packing);
[[nodiscard]] std::string_view title(Technique technique);
/// "Wald, record, early"
[[nodiscard]] std::string title(const Form& form);

}  // namespace carom::render::triangle
