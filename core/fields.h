// The list of the fields of a described struct. Hashes, files, JSON and their tests use that list,
// so that each field is named in one place. A list that lacks a field does not compile.
//
// The list is in a *_fields.h beside the struct's header, in the same namespace, in the order in
// which the fields are hashed:
//
//   constexpr auto fields_of(Describes<Sphere>) {
//       return fields<Sphere>(field("radius", &Sphere::radius));
//   }
#pragma once

#include <concepts>
#include <cstddef>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

namespace carom {

/// How a field enters the hash of its struct (core/field_hasher.h).
enum class FieldRole {
    value,             // its value is hashed
    value_if_given,    // an optional field, hashed if given; other fields say whether it is given
    file,              // the path of a file whose contents are hashed
    hashed_elsewhere,  // hashed by the code that the reason names
    unhashed,          // not hashed
};

template <FieldRole kFieldRole, class Owner, class Value>
struct Field {
    static constexpr FieldRole kRole = kFieldRole;
    std::string_view name;
    Value Owner::*member;
    std::string_view reason{};  // for roles other than `value` and `file`
};

template <class Owner, class Value>
constexpr Field<FieldRole::value, Owner, Value> field(std::string_view name, Value Owner::*member) {
    return {name, member};
}

template <class Owner, class Value>
constexpr Field<FieldRole::file, Owner, Value> file_field(std::string_view name,
                                                          Value Owner::*member) {
    return {name, member};
}

template <class Owner, class Value>
constexpr Field<FieldRole::value_if_given, Owner, Value> field_if_given(std::string_view name,
                                                                        Value Owner::*member,
                                                                        std::string_view reason) {
    return {name, member, reason};
}

template <class Owner, class Value>
constexpr Field<FieldRole::hashed_elsewhere, Owner, Value> hashed_elsewhere(
    std::string_view name, Value Owner::*member, std::string_view reason) {
    return {name, member, reason};
}

template <class Owner, class Value>
constexpr Field<FieldRole::unhashed, Owner, Value> unhashed(std::string_view name,
                                                            Value Owner::*member,
                                                            std::string_view reason) {
    return {name, member, reason};
}

/// Selects the overload of fields_of.
template <class T>
struct Describes {};

/// A struct with a list of its fields.
template <class T>
concept Described = requires {
    fields_of(Describes<T>{});
};

namespace detail {

/// Initialises any member, in unevaluated expressions only.
struct Anything {
    template <class T>
    operator T() const noexcept;  // NOLINT(google-explicit-constructor)
};

template <class T, std::size_t... kIndex>
constexpr bool takes_initialisers(std::index_sequence<kIndex...> /*count*/) {
    return requires {
        T{(static_cast<void>(kIndex), Anything{})...};
    };
}

/// True if the aggregate T has kCount members: it takes as many initialisers, and not more.
template <class T, std::size_t kCount>
constexpr bool has_members() {
    return takes_initialisers<T>(std::make_index_sequence<kCount>{}) &&
           !takes_initialisers<T>(std::make_index_sequence<kCount + 1>{});
}

template <class A, class B>
constexpr bool are_of_one_member(const A& a, const B& b) {
    if constexpr (std::same_as<decltype(a.member), decltype(b.member)>) {
        return a.member == b.member;
    } else {
        return false;
    }
}

constexpr bool have_different_members() {
    return true;
}

template <class First, class... Rest>
constexpr bool have_different_members(const First& first, const Rest&... rest) {
    return (!are_of_one_member(first, rest) && ...) && have_different_members(rest...);
}

}  // namespace detail

/// The list of all fields of T; it has to name each field exactly once.
template <class T, class... Listed>
consteval std::tuple<Listed...> fields(Listed... listed) {
    static_assert(detail::has_members<T, sizeof...(Listed)>(),
                  "the list does not name as many fields as the struct has");
    if (!detail::have_different_members(listed...)) {
        throw "the list names a field twice";  // fails at compile time
    }
    return {listed...};
}

template <Described T>
inline constexpr auto kFields = fields_of(Describes<T>{});

template <Described T>
inline constexpr std::size_t kFieldCount = std::tuple_size_v<decltype(kFields<T>)>;

/// Calls visit(field, value) for each field in the order of the list.
template <class T, class Visit>
requires Described<std::remove_const_t<T>>
constexpr void for_each_field(T& object, Visit&& visit) {
    std::apply([&](const auto&... listed) { (visit(listed, object.*listed.member), ...); },
               kFields<std::remove_const_t<T>>);
}

}  // namespace carom
