// Maps the fields of structs in the bake file to the members of the same name (core/fields.h). If
// bake.fbs and the list of fields do not have the same names, the program does not compile.
#pragma once

#include <cstddef>
#include <string_view>
#include <tuple>

#include "bake_generated.h"
#include "sim/timeline/event_fields.h"
#include "sim/timeline/track_fields.h"

namespace carom::sim {

/// The number of members that the file stores elsewhere: a struct in a file cannot grow.
template <class T>
inline constexpr std::size_t kStoredElsewhere = 0;
template <>
inline constexpr std::size_t kStoredElsewhere<EnergySample> = 1;  // Content.energy_work

template <class T, class Struct, std::size_t kIndex>
consteval std::size_t index_in_list() {
    static_assert(kFieldCount<T> == Struct::Traits::fields_number + kStoredElsewhere<T>,
                  "bake.fbs does not have as many fields as the list");
    const std::string_view name = Struct::Traits::field_names[kIndex];
    std::size_t index = 0;
    std::apply(
        [&](const auto&... listed) { (void)(((listed.name == name) || (++index, false)) || ...); },
        kFields<T>);
    if (index == kFieldCount<T>) {
        throw "bake.fbs names a field that is not in the list";  // fails at compile time
    }
    return index;
}

/// The member of T that corresponds to the struct's field number kIndex.
template <class T, class Struct, std::size_t kIndex>
inline constexpr auto kMember = std::get<index_in_list<T, Struct, kIndex>()>(kFields<T>).member;

}  // namespace carom::sim
