// A direction towards a light, in lanes. Included as render/lanes/kernels/vectors.h is.

/// A sampled direction, with the radiance from there. Where it is not valid, no light arrives.
template <class L>
struct LightSampleOf {
    Vec3<typename L::Value> direction;  // unit, from the point
    typename L::Value distance;         // m
    typename L::Value pdf;              // 1/sr
    Vec3<typename L::Value> radiance;   // W/(m^2 sr)
    typename L::Mask valid;
};
