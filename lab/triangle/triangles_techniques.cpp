#include "lab/triangle/run_factories.h"

// See rays_runs.cpp.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_SSE4 | HWY_AVX3 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "lab/triangle/triangles_techniques.cpp"
#include <hwy/foreach_target.h>  // compiles this file once per instruction set
// Must follow foreach_target.h.
#include <hwy/highway.h>

#include "lab/triangle/triangles_run-inl.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::triangle::HWY_NAMESPACE {

constexpr bool is_of_triangles_techniques(const Variant& variant) {
    return is_several_triangles(variant.packing) && variant.technique != Technique::plain;
}

inline std::unique_ptr<KernelRun> make_triangles_technique_of_target(const Variant& variant,
                                                                     const TestSet& set) {
    return make_variant<MakeTrianglesRun, is_of_triangles_techniques>(variant, set);
}

}  // namespace carom::render::triangle::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace carom::render::triangle {

HWY_EXPORT(make_triangles_technique_of_target);

std::unique_ptr<KernelRun> make_triangles_technique(const Variant& variant, const TestSet& set) {
    return HWY_DYNAMIC_DISPATCH(make_triangles_technique_of_target)(variant, set);
}

}  // namespace carom::render::triangle

#endif
