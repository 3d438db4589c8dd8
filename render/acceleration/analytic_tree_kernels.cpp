#include "render/acceleration/analytic_tree_kernels.h"

// See analytic_kernels.cpp.
#define HWY_DISABLED_TARGETS (HWY_AVX3 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/acceleration/analytic_tree_kernels.cpp"
#include <hwy/foreach_target.h>  // compiles this file once per instruction set
// Must follow foreach_target.h.
#include <hwy/highway.h>

#include "render/acceleration/analytic_tree_queries-inl.h"

HWY_BEFORE_NAMESPACE();
namespace carom::render::HWY_NAMESPACE {

inline HWY_ATTR void closest_in_tree(const AnalyticTree& tree, const Ray& ray, Hit& best) {
    (void)ask_tree(tree, tree.tree, ray, best.t, ClosestInBlock{&best});
}
inline HWY_ATTR bool any_in_tree(const AnalyticTree& tree, const Ray& ray) {
    return ask_tree(tree, tree.tree, ray, ray.t_max, AnyInBlock{ray.t_max});
}

inline const AnalyticTreeKernels& tree_kernels_of_target() {
    static const AnalyticTreeKernels kKernels = {closest_in_tree, any_in_tree};
    return kKernels;
}

}  // namespace carom::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace carom::render {

HWY_EXPORT(tree_kernels_of_target);

const AnalyticTreeKernels& best_tree_kernels() {
    return HWY_DYNAMIC_DISPATCH(tree_kernels_of_target)();
}

}  // namespace carom::render

#endif
