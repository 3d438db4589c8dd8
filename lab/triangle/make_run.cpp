#include "core/assert.h"
#include "lab/triangle/kernel_run.h"
#include "lab/triangle/run_factories.h"

namespace carom::render::triangle {

std::unique_ptr<KernelRun> make_run(const Variant& variant, const TestSet& set) {
    CAROM_ASSERT(set.rays_in_group % 8 == 0);
    CAROM_ASSERT(set.triangles_in_group % 8 == 0);
    for (const auto make : {make_single_run, make_rays_run, make_triangles_run, make_rays_technique,
                            make_triangles_technique}) {
        if (std::unique_ptr<KernelRun> run = make(variant, set)) {
            return run;
        }
    }
    return nullptr;
}

}  // namespace carom::render::triangle
