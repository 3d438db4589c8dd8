// Intersection tests of all analytic shapes in vector lanes: one ray against several shapes, or
// several rays against one shape. Included once per instruction set.
#include "render/acceleration/lane_tests/box_test-inl.h"
#include "render/acceleration/lane_tests/lane_test-inl.h"
#include "render/acceleration/lane_tests/sphere_test-inl.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

/// The test of a shape for one ray in all lanes; `direction` is the ray's.
template <class Shape, class D>
HWY_INLINE LaneTest<Shape> test_for_ray(Shape /*shape*/, D /*d*/, const V3f& /*direction*/) {
    return {};
}
template <class D>
HWY_INLINE AlignedBoxTest<D> test_for_ray(AlignedBox /*shape*/, D d, const V3f& direction) {
    return AlignedBoxTest<D>(d, direction);
}

/// The test of a shape for rays that differ from lane to lane; `inverse`: finite_reciprocals of
/// their directions.
template <class Shape, class V>
HWY_INLINE LaneTest<Shape> test_for_rays(Shape /*shape*/, const Three<V>& /*inverse*/) {
    return {};
}
template <class V>
HWY_INLINE AlignedBoxRays<hn::DFromV<V>> test_for_rays(AlignedBox /*shape*/,
                                                       const Three<V>& inverse) {
    return {inverse};
}

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
