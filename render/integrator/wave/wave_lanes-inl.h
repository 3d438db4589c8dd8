// Loads and stores of path_queues.h's arrays. Included once per instruction set.
#if defined(CAROM_WAVE_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CAROM_WAVE_LANES_INL_H
#undef CAROM_WAVE_LANES_INL_H
#else
#define CAROM_WAVE_LANES_INL_H
#endif

#include <cstddef>
#include <vector>

#include "render/integrator/kernels-inl.h"
#include "render/integrator/wave/path_queues.h"
#include "render/lanes/packed_lanes-inl.h"
#include "render/light/kernels-inl.h"
#include "render/material/kernels-inl.h"
#include "render/sampling/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

HWY_INLINE M no_lanes() {
    return hn::MaskFromVec(hn::Zero(FloatTag()));
}
HWY_INLINE F load(const Floats& field, int i) {
    return hn::LoadU(FloatTag(), field.at + i);
}
HWY_INLINE F3 load(const Floats3& field, int i) {
    return {load(field.x, i), load(field.y, i), load(field.z, i)};
}
HWY_INLINE I load(const Words& field, int i) {
    return hn::LoadU(IntTag(), field.at + i);
}
HWY_INLINE F gather(const Floats& field, I index) {
    return hn::GatherIndex(FloatTag(), field.at, index);
}
HWY_INLINE F3 gather(const Floats3& field, I index) {
    return {gather(field.x, index), gather(field.y, index), gather(field.z, index)};
}
HWY_INLINE I gather(const Words& field, I index) {
    return hn::GatherIndex(IntTag(), field.at, index);
}
HWY_INLINE F gather(const std::vector<float>& numbers, I index) {
    return hn::GatherIndex(FloatTag(), numbers.data(), index);
}
HWY_INLINE void store(F value, Floats& field, int i) {
    hn::StoreU(value, FloatTag(), field.at + i);
}
HWY_INLINE void store(const F3& value, Floats3& field, int i) {
    store(value.x, field.x, i);
    store(value.y, field.y, i);
    store(value.z, field.z, i);
}
/// Stores the lanes in `goes` without gaps; what follows them is undefined. (Some processors take a
/// hundred cycles for the instruction that stores just these.)
HWY_INLINE void store_some(F value, const PackedLanes& goes, Floats& field, int i) {
    hn::StoreU(goes.pack(value), FloatTag(), field.at + i);
}
HWY_INLINE void store_some(const F3& value, const PackedLanes& goes, Floats3& field, int i) {
    store_some(value.x, goes, field.x, i);
    store_some(value.y, goes, field.y, i);
    store_some(value.z, goes, field.z, i);
}
HWY_INLINE void store_some(I value, const PackedLanes& goes, Words& field, int i) {
    hn::StoreU(goes.pack(value), IntTag(), field.at + i);
}

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // once per instruction set
