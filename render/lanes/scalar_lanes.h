// The lane type of scalar code: a single number where vector code has several.
#pragma once

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

namespace carom::render {

/// The operations that formulas over lanes need from a lane type; each gives the bits of
/// VectorLanes. T: float, double or long double; integers, bits and loads are for floats only.
/// Numbers also have + - * /, integers and words + - * & | ^.
template <class T>
struct ScalarLanes {
    using Number = T;
    using Value = T;
    using Mask = bool;
    using Int = std::int32_t;
    using Word = std::uint32_t;
    static constexpr Number kLargest = std::numeric_limits<T>::max();  // that is finite

    static Value all(Number x) { return x; }
    static Int all_int(std::int32_t x) { return x; }
    static Word all_word(std::uint32_t x) { return x; }
    /// How many lanes there are.
    static int count() { return 1; }
    /// `first` and the numbers that follow it.
    static Int from(std::int32_t first) { return first; }
    /// The first `n` lanes; n >= 0.
    static Mask first_lanes(int n) { return n > 0; }
    /// The number in the first lane.
    static std::int32_t first_of(Int x) { return x; }
    /// The smallest number of the lanes in the mask, which is not empty.
    static std::int32_t smallest_of(Mask /*mask*/, Int x) { return x; }

    static Mask is_less(Value a, Value b) { return a < b; }
    static Mask is_at_most(Value a, Value b) { return a <= b; }
    static Mask is_equal(Value a, Value b) { return a == b; }
    static Mask is_equal_int(Int a, Int b) { return a == b; }
    static Mask is_less_int(Int a, Int b) { return a < b; }
    static Mask is_less_word(Word a, Word b) { return a < b; }
    static Mask both(Mask a, Mask b) { return a && b; }
    static Mask either(Mask a, Mask b) { return a || b; }
    static Mask opposite(Mask a) { return !a; }
    static Mask without(Mask a, Mask b) { return a && !b; }
    static bool none(Mask mask) { return !mask; }
    static int count_of(Mask mask) { return mask ? 1 : 0; }
    /// Whether an early return between two tests pays off. For a scalar it does; with several lanes
    /// all must fail, which is rare and cannot be predicted.
    static bool fails_alone(Mask mask) { return !mask; }

    static Value select(Mask mask, Value yes, Value no) { return mask ? yes : no; }
    static Mask select_mask(Mask mask, Mask yes, Mask no) { return mask ? yes : no; }
    static Int select_int(Mask mask, Int yes, Int no) { return mask ? yes : no; }

    /// A function of two numbers, for formulas that are too rare for code of their own.
    template <class Function>
    static Value lane_by_lane(const Function& function, Value a, Value b) {
        return function(a, b);
    }

    static Value size(Value x) { return std::abs(x); }
    static Value opposite_sign(Value x) { return -x; }
    static Value smaller(Value a, Value b) { return a < b ? a : b; }
    static Value larger(Value a, Value b) { return a > b ? a : b; }
    static Int smaller_int(Int a, Int b) { return a < b ? a : b; }
    static Int larger_int(Int a, Int b) { return a > b ? a : b; }
    static Int product(Int a, std::int32_t b) { return a * b; }
    static Value root(Value x) { return std::sqrt(x); }
    static Value inverse(Value x) { return 1 / x; }
    static Value rounded_down(Value x) { return std::floor(x); }

    /// Rounds towards 0; |x| < 2^31.
    static Int to_int(Value x) { return static_cast<Int>(x); }
    static Value to_value(Int x) { return static_cast<Value>(x); }
    static Int bits_of(Value x) { return std::bit_cast<Int>(x); }
    static Value from_bits(Int x) { return std::bit_cast<Value>(x); }
    static Word to_word(Int x) { return static_cast<Word>(x); }
    static Int from_word(Word x) { return static_cast<Int>(x); }
    template <int kBits>
    static Word shifted_left(Word x) {
        return x << kBits;
    }
    template <int kBits>
    static Word shifted_right(Word x) {
        return x >> kBits;
    }
    static Word shifted_right(Word x, Word bits) { return x >> bits; }
    static Word shifted_right_by(Word x, int bits) { return x >> bits; }
    /// A number of a table, for an index in [0, 15].
    static Word one_of_sixteen(const std::uint32_t (&table)[16], Int index) { return table[index]; }
    static constexpr Word reversed_bits(Word x) {
        x = ((x >> 1) & 0x55555555u) | ((x & 0x55555555u) << 1);
        x = ((x >> 2) & 0x33333333u) | ((x & 0x33333333u) << 2);
        x = ((x >> 4) & 0x0f0f0f0fu) | ((x & 0x0f0f0f0fu) << 4);
        x = ((x >> 8) & 0x00ff00ffu) | ((x & 0x00ff00ffu) << 8);
        return (x >> 16) | (x << 16);
    }
    /// With the sign.
    template <int kBits>
    static Int shifted_right_int(Int x) {
        return x >> kBits;
    }

    /// The numbers that lie one after the other, and their storing.
    static Value load(const Number* from) { return *from; }
    static Int load_int(const std::int32_t* from) { return *from; }
    static void store(Value x, Number* to) { *to = x; }
    static void store_int(Int x, std::int32_t* to) { *to = x; }

    static Value gather(const float* numbers, Int index) { return numbers[index]; }
    static void scatter(Value x, float* numbers, Int index) { numbers[index] = x; }
    static Int gather_int(const std::int32_t* numbers, Int index) { return numbers[index]; }
    /// The 32 bits that begin at a byte of a memory that may hold any type; there must be as many.
    static Word gather_bytes(const void* from, Int byte) {
        Word word = 0;
        std::memcpy(&word, static_cast<const char*>(from) + byte, sizeof(word));
        return word;
    }

    /// Two numbers that lie side by side, at `index` and behind it.
    struct Pair {
        Value first, second;
    };
    static Pair gather_pair(const float* numbers, Int index) {
        return {numbers[index], numbers[index + 1]};
    }
    struct WordPair {
        Word first, second;
    };
    /// The 32 bits that begin at a byte, and the next 32.
    static WordPair gather_bytes_pair(const void* from, Int byte) {
        return {gather_bytes(from, byte), gather_bytes(from, byte + 4)};
    }

    /// x, negated where `by` is negative.
    static Value flip_sign(Value x, Value by) {
        if constexpr (std::is_same_v<T, float>) {
            return std::bit_cast<float>(std::bit_cast<std::uint32_t>(x) ^
                                        (std::bit_cast<std::uint32_t>(by) & 0x80000000u));
        } else if constexpr (std::is_same_v<T, double>) {
            return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) ^
                                         (std::bit_cast<std::uint64_t>(by) & (1ull << 63)));
        } else {
            return std::signbit(by) ? -x : x;
        }
    }
};

}  // namespace carom::render
