// Assertions for programming errors; user errors are `Error` (error.h). A failed assertion prints
// its place in the source and aborts.
//   CAROM_ASSERT(condition)     cheap; enabled in every preset, also for users
//   CAROM_VALIDATE(condition)   expensive; enabled in the debug, test, asan and fuzz presets
// If the condition is a single comparison, both values are printed: "assertion failed: count < size
// (4 < 3)". For that the condition is evaluated a second time.
#pragma once

#include <type_traits>

namespace carom::detail {

/// A value in the message of a failed assertion.
struct Operand {
    enum class Kind { unprintable, boolean, signed_integer, unsigned_integer, real, pointer, text };

    Kind kind = Kind::unprintable;
    unsigned long long bits = 0;  // of a boolean or an integer; length of a text in bytes
    double number = 0;
    int digits = 0;  // enough to distinguish neighbouring numbers of the operand's type
    const void* address = nullptr;
};

template <class T>
[[gnu::always_inline]] inline Operand operand_of(const T& value) {
    using Kind = Operand::Kind;
    if constexpr (std::is_same_v<T, bool>) {
        return {Kind::boolean, value};
    } else if constexpr (std::is_enum_v<T>) {
        return operand_of(static_cast<std::underlying_type_t<T>>(value));
    } else if constexpr (std::is_integral_v<T>) {
        return {std::is_signed_v<T> ? Kind::signed_integer : Kind::unsigned_integer,
                static_cast<unsigned long long>(value)};
    } else if constexpr (std::is_floating_point_v<T>) {
        return {Kind::real, 0, static_cast<double>(value), sizeof(T) == sizeof(float) ? 9 : 17};
    } else if constexpr (std::is_null_pointer_v<T>) {
        return {Kind::pointer};
    } else if constexpr (std::is_pointer_v<T> && !std::is_function_v<std::remove_pointer_t<T>>) {
        return {Kind::pointer, 0, 0, 0, value};
    } else if constexpr (requires { static_cast<const char*>(value.data()), value.size(); }) {
        return {Kind::text, value.size(), 0, 0, value.data()};
    } else {
        return {};
    }
}

struct Comparison {
    Operand left;
    const char* sign = nullptr;  // null: not a comparison
    Operand right;

    explicit operator bool() const { return false; }  // for && and ||, which hide the values
};

/// The left side of a comparison, or the whole condition if it is not a comparison.
template <class T>
struct LeftSide {
    const T& value;

    template <class U>
    [[gnu::always_inline]] Comparison compare(const char* sign, const U& right) const {
        return {operand_of(value), sign, operand_of(right)};
    }
    template <class U>
    [[gnu::always_inline]] Comparison operator==(const U& right) const {
        return compare("==", right);
    }
    template <class U>
    [[gnu::always_inline]] Comparison operator!=(const U& right) const {
        return compare("!=", right);
    }
    template <class U>
    [[gnu::always_inline]] Comparison operator<(const U& right) const {
        return compare("<", right);
    }
    template <class U>
    [[gnu::always_inline]] Comparison operator<=(const U& right) const {
        return compare("<=", right);
    }
    template <class U>
    [[gnu::always_inline]] Comparison operator>(const U& right) const {
        return compare(">", right);
    }
    template <class U>
    [[gnu::always_inline]] Comparison operator>=(const U& right) const {
        return compare(">=", right);
    }
    explicit operator bool() const { return false; }
    [[gnu::always_inline]] operator Comparison() const { return {}; }
};

/// `Decomposer() << a < b` compares a with b: << has higher precedence than <.
struct Decomposer {
    template <class T>
    [[gnu::always_inline]] LeftSide<T> operator<<(const T& value) const {
        return {value};
    }
};

[[noreturn]] void assertion_failed(const char* condition, const char* file, int line,
                                   const Comparison& values);
[[noreturn]] void assertion_failed(const char* condition, const char* file, int line, bool values);

}  // namespace carom::detail

// In parentheses the condition could not be taken apart.
// NOLINTBEGIN(bugprone-macro-parentheses)
#define CAROM_CHECK_CONDITION(condition)                                             \
    ((condition) ? void(0)                                                           \
                 : ::carom::detail::assertion_failed(#condition, __FILE__, __LINE__, \
                                                     ::carom::detail::Decomposer() << condition))
// NOLINTEND(bugprone-macro-parentheses)

#ifdef CAROM_ASSERTIONS
#define CAROM_ASSERT(condition) CAROM_CHECK_CONDITION(condition)
#else
#define CAROM_ASSERT(condition) void(sizeof(!(condition)))
#endif

#ifdef CAROM_VALIDATION
#define CAROM_VALIDATE(condition) CAROM_CHECK_CONDITION(condition)
#else
#define CAROM_VALIDATE(condition) void(sizeof(!(condition)))
#endif
