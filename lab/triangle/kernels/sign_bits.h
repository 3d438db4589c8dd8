/// Tests by integer operations: numbers are within bounds if their differences have the same sign
/// bit, so that the sign of the denominator need not be known (as in Shevtsov, Soupikov and
/// Kapustin 2007, and in Keidy's code). Numbers that are exactly on a bound may fall on either
/// side, because 0 and -0 have different bits, and weights that are not numbers pass: of slivers
/// whose record is not a record of numbers.
template <class Base>
struct SignBitLanes : Base {
    using typename Base::Mask;
    using typename Base::Value;
    static constexpr bool kTestsSignBits = true;

    CAROM_KERNEL static Mask same_sign(Value a, Value b) {
        return is_not_negative(Base::bits_of(a) ^ Base::bits_of(b));
    }
    CAROM_KERNEL static Mask same_sign(Value a, Value b, Value c) {
        const auto bits = Base::bits_of(a);
        return is_not_negative((bits ^ Base::bits_of(b)) | (bits ^ Base::bits_of(c)));
    }

  private:
    CAROM_KERNEL static Mask is_not_negative(typename Base::Int bits) {
        return Base::is_less_int(Base::all_int(-1), bits);
    }
};

/// Numbers are multiples by the denominator itself, with its sign.
template <class L>
requires(L::kTestsSignBits) class Denominator<Division::deferred, L> {
    using V = typename L::Value;

  public:
    CAROM_KERNEL explicit Denominator(V value) : value_(value) {}

    [[nodiscard]] CAROM_KERNEL V quotient(V numerator) const { return numerator; }
    [[nodiscard]] CAROM_KERNEL V whole() const { return value_; }
    [[nodiscard]] CAROM_KERNEL V times(V x) const { return x * value_; }

  private:
    V value_;
};

template <class L, Division kDivision>
requires(L::kTestsSignBits) CAROM_KERNEL typename L::Mask
    is_within(const RayIn<L>& ray, const Denominator<kDivision, L>& below, typename L::Value t) {
    return L::same_sign(t - below.times(ray.t_min), below.times(ray.t_max) - t);
}

/// The upper bound follows from the test of the second weight.
template <class L>
requires(L::kTestsSignBits) CAROM_KERNEL typename L::Mask
    is_weight(typename L::Value u, typename L::Value whole) {
    return L::same_sign(u, whole);
}
template <class L>
requires(L::kTestsSignBits) CAROM_KERNEL typename L::Mask
    is_second_weight(typename L::Value u, typename L::Value v, typename L::Value whole) {
    return L::same_sign(u, v, whole - u - v);
}
