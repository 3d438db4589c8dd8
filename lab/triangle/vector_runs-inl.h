// A factory of runs in vector lanes, compiled for every instruction set. The file that includes
// this defines CAROM_MAKE_RUN, the factory's name in run_factories.h; CAROM_RUN, the class template
// of the runs; and CAROM_IS_OF_RUN(variant), whether the factory makes the variant.
#include "lab/triangle/run_factories.h"

// The targets between gain nothing; those above AVX2 are not used anywhere.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_SSE4 | HWY_AVX3 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "lab/triangle/vector_runs-inl.h"
#include <hwy/foreach_target.h>  // compiles this file once per instruction set
// Must follow foreach_target.h.
#include <hwy/highway.h>

#include "lab/triangle/make_variant.h"
#include "lab/triangle/rays_run-inl.h"
#include "lab/triangle/triangles_run-inl.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::triangle::HWY_NAMESPACE {
namespace {

constexpr bool is_of_run(const Variant& variant) {
    return CAROM_IS_OF_RUN(variant);
}

std::unique_ptr<KernelRun> make_run_of_target(const Variant& variant, const TestSet& set) {
    return make_variant<CAROM_RUN, is_of_run>(variant, set);
}

}  // namespace
}  // namespace carom::render::triangle::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace carom::render::triangle {

HWY_EXPORT(make_run_of_target);

std::unique_ptr<KernelRun> CAROM_MAKE_RUN(const Variant& variant, const TestSet& set) {
    return HWY_DYNAMIC_DISPATCH(make_run_of_target)(variant, set);
}

}  // namespace carom::render::triangle

#endif
