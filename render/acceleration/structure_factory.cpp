#include "render/acceleration/structure_factory.h"

#include <algorithm>

#include "render/scene/acceleration_names.h"

namespace carom::render {

std::optional<StructureProblem> structure_problem(AccelerationKind kind, StructureFactory factory) {
    const bool is_ours = kind == AccelerationKind::hybrid || kind == AccelerationKind::embree ||
                         kind == AccelerationKind::wide_bvh;
    if (is_ours || factory != nullptr) {
        return std::nullopt;
    }
    const auto found = std::ranges::find(kAccelerationNames, kind, &AccelerationName::kind);
    const std::string program = "carom-lab";
    return StructureProblem{kind, program,
                            "the acceleration structure '" + std::string(found->name) +
                                "' is for comparison; only the program " + program + " has it"};
}

}  // namespace carom::render
