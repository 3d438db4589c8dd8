#include "render/light/emissive_object.h"

#include <utility>

namespace carom::render {
EmissiveObject EmissiveObject::moving(std::shared_ptr<const RigidMotion> motion) const {
    EmissiveObject result = *this;
    result.motion_ = std::move(motion);
    return result;
}

const EmissiveSurface* EmissiveObject::flat() const {
    const auto* surface = std::get_if<std::shared_ptr<const EmissiveSurface>>(&shape_);
    return surface != nullptr ? surface->get() : nullptr;
}

bool EmissiveObject::is_black() const {
    return visit([](const auto& shape) { return shape.is_black(); });
}

bool EmissiveObject::is_round() const {
    const EmissiveShape* shape = curved();
    return shape != nullptr && shape->is_round();
}

}  // namespace carom::render
