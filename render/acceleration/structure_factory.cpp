#include "render/acceleration/structure_factory.h"

#include <algorithm>
#include <string>

#include "render/scene/acceleration_names.h"

namespace carom::render {

std::optional<Diagnostic> find_problem(AccelerationKind kind, StructureFactory factory) {
    const bool is_made_here = kind == AccelerationKind::hybrid ||
                              kind == AccelerationKind::embree ||
                              kind == AccelerationKind::wide_bvh;
    if (is_made_here || factory != nullptr) {
        return std::nullopt;
    }
    const auto found = std::ranges::find(kAccelerationNames, kind, &AccelerationName::kind);
    return Diagnostic{{Subject::Kind::settings},
                      "acceleration",
                      "the acceleration structure '" + std::string(found->name) +
                          "' is for comparison; only the program " + kComparisonProgram +
                          " has it"};
}

}  // namespace carom::render
