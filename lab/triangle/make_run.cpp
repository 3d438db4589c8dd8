#include "core/assert.h"
#include "lab/triangle/kernel_run.h"
#include "lab/triangle/run_factories.h"

namespace carom::render::triangle {

std::unique_ptr<KernelRun> make_run(const Variant& variant, const TestSet& set) {
    CAROM_ASSERT(set.rays_in_group % 8 == 0);
    CAROM_ASSERT(set.triangles_in_group % 8 == 0);
    return make_run_of_any(variant, set);
}

}  // namespace carom::render::triangle
