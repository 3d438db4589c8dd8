#include "lab/triangle/run_factories.h"

// The targets between gain nothing; those above AVX2 are not used anywhere.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_SSE4 | HWY_AVX3 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "lab/triangle/rays_runs.cpp"
#include <hwy/foreach_target.h>  // compiles this file once per instruction set
// Must follow foreach_target.h.
#include <hwy/highway.h>

#include "lab/triangle/rays_run-inl.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::triangle::HWY_NAMESPACE {

constexpr bool is_of_rays_runs(const Variant& variant) {
    return (variant.packing == Packing::four_rays || variant.packing == Packing::eight_rays) &&
           variant.technique == Technique::plain;
}

inline std::unique_ptr<KernelRun> make_rays_run_of_target(const Variant& variant,
                                                          const TestSet& set) {
    return make_variant<MakeRaysRun, is_of_rays_runs>(variant, set);
}

}  // namespace carom::render::triangle::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace carom::render::triangle {

HWY_EXPORT(make_rays_run_of_target);

std::unique_ptr<KernelRun> make_rays_run(const Variant& variant, const TestSet& set) {
    return HWY_DYNAMIC_DISPATCH(make_rays_run_of_target)(variant, set);
}

}  // namespace carom::render::triangle

#endif
