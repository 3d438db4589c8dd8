/// Reciprocals by the processor's estimate y of about 12 bits, improved by one step of Newton's
/// method: y (2 - x y).
template <class Base>
struct NewtonLanes : Base {
    using typename Base::Value;

    CAROM_KERNEL static Value inverse(Value x) {
        const auto y = estimated_inverse(x);
        return y * (Base::all(2) - x * y);
    }
};
