#include "tests/render/texture/texture_lanes.h"

#include <array>
#include <cstring>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/render/texture/texture_lanes.cpp"
#include <hwy/foreach_target.h>  // compiles this file once per instruction set
// Must follow foreach_target.h.
#include <hwy/highway.h>

#include "render/texture/kernels-inl.h"
#include "tests/render/every_target.h"
#include "tests/render/texture/texture_values.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

using Numbers = hn::CappedTag<float, 16>;
using Value = hn::Vec<Numbers>;

HWY_INLINE void store_three(const Vec3<Value>& v, float* const (&to)[3], std::size_t first) {
    const Numbers d;
    hn::StoreU(v.x, d, to[0] + first);
    hn::StoreU(v.y, d, to[1] + first);
    hn::StoreU(v.z, d, to[2] + first);
}
HWY_INLINE TexturePointOf<Lanes> load_point(const test::PointLists& points, std::size_t first) {
    TexturePointOf<Lanes> point{};
    static_assert(sizeof(point) == test::PointLists::kNumbers * sizeof(Value));
    std::array<Value, test::PointLists::kNumbers> numbers;
    for (std::size_t k = 0; k < numbers.size(); ++k) {
        numbers[k] = hn::LoadU(Numbers(), &points.numbers[k][first]);
    }
    std::memcpy(&point, &numbers, sizeof(point));
    return point;
}

HWY_ATTR void all_colours(const TextureData& texture, const test::PointLists& points,
                          float* const colour[3]) {
    const Numbers d;
    float* const to[3] = {colour[0], colour[1], colour[2]};
    for (std::size_t i = 0; i < points.size(); i += hn::Lanes(d)) {
        store_three(value_of<Lanes>(texture, load_point(points, i), nullptr).colour, to, i);
    }
}

HWY_ATTR void all_reliefs(const TextureData& texture, const test::PointLists& points,
                          float* const colour[3], float* const shift[3]) {
    const Numbers d;
    float* const colours[3] = {colour[0], colour[1], colour[2]};
    float* const shifts[3] = {shift[0], shift[1], shift[2]};
    for (std::size_t i = 0; i < points.size(); i += hn::Lanes(d)) {
        const TextureReliefOf<Lanes> relief =
            relief_of_cloth<Lanes>(texture, load_point(points, i));
        store_three(relief.colour, colours, i);
        store_three(relief.normal_shift, shifts, i);
    }
}

HWY_ATTR void all_halves(const std::vector<std::uint32_t>& words, float* values) {
    const Numbers d;
    for (std::size_t i = 0; i < words.size(); i += hn::Lanes(d)) {
        hn::StoreU(half_value<Lanes>(hn::LoadU(hn::RebindToUnsigned<Numbers>(), &words[i])), d,
                   values + i);
    }
}

const test::TextureLanes& texture_lanes_of_target() {
    static const test::TextureLanes kLanes = {all_colours, all_reliefs, all_halves,
                                              hwy::TargetName(HWY_TARGET)};
    return kLanes;
}

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace carom::render {

HWY_EXPORT(texture_lanes_of_target);

}  // namespace carom::render

namespace carom::test {

void PointLists::add(const render::SurfacePoint& point, float width) {
    const auto textured = texture_point(point, width);
    std::array<float, kNumbers> of_point;
    static_assert(sizeof(textured) == sizeof(of_point));
    std::memcpy(&of_point, &textured, sizeof(textured));
    for (std::size_t k = 0; k < kNumbers; ++k) {
        numbers[k].push_back(of_point[k]);
    }
}

const TextureLanes& best_texture_lanes() {
    using namespace render;
    return HWY_DYNAMIC_DISPATCH(texture_lanes_of_target)();
}

void for_every_target(const std::function<void(const TextureLanes& lanes)>& use) {
    for_each_instruction_set([&](const char*) { use(best_texture_lanes()); });
}

}  // namespace carom::test

#endif
