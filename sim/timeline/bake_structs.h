// Which field of a described struct a struct of the bake file keeps: the one of the same name.
// Where bake.fbs and the list of fields (core/fields.h) do not name the same fields, nothing
// compiles.
#pragma once

#include <cstddef>
#include <string_view>
#include <tuple>

#include "bake_generated.h"
#include "sim/timeline/event_fields.h"
#include "sim/timeline/track_fields.h"

namespace carom::sim {

template <class T, class Struct, std::size_t kIndex>
consteval std::size_t place_in_list() {
    static_assert(kFieldCount<T> == Struct::Traits::fields_number,
                  "bake.fbs does not have as many fields as the list");
    const std::string_view name = Struct::Traits::field_names[kIndex];
    std::size_t place = 0;
    std::apply(
        [&](const auto&... listed) { (void)(((listed.name == name) || (++place, false)) || ...); },
        kFields<T>);
    if (place == kFieldCount<T>) {
        throw "bake.fbs names a field that is not in the list";  // which nothing constant may do
    }
    return place;
}

/// The member of T that the struct's field number kIndex keeps.
template <class T, class Struct, std::size_t kIndex>
inline constexpr auto kMember = std::get<place_in_list<T, Struct, kIndex>()>(kFields<T>).member;

}  // namespace carom::sim
