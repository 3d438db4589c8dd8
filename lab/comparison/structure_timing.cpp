#include "lab/comparison/structure_timing.h"

namespace carom::pipeline {

RaysByKind thinned(const RaysByKind& rays, std::size_t every) {
    RaysByKind some;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        for (std::size_t k = 0; k < rays[i].size(); k += every) {
            some[i].push_back(rays[i][k]);
        }
    }
    return some;
}

}  // namespace carom::pipeline
