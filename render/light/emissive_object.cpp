#include "render/light/emissive_object.h"

#include <algorithm>
#include <utility>

#include "core/elementary.h"

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

LightBounds EmissiveObject::bounds() const {
    LightBounds in_body = flat() != nullptr ? flat()->bounds() : curved()->bounds();
    if (motion_ == nullptr) {
        return in_body;
    }
    const RigidMotion::Orientations turned = motion_->orientations();
    const V3f centre = in_body.box.center();
    // How far the centre is at most from where the nearest of the orientations has it.
    const float beside =
        2 * centre.length() *
        static_cast<float>(sine(0.5 * static_cast<double>(std::min(turned.within, kPi))));
    const V3f around = V3f(1, 1, 1) * (0.5f * in_body.box.size().length() + beside);
    LightBounds swept;
    for (const Imath::Quatf& orientation : turned.world_from_body) {
        const V3f arm = rotate(orientation, centre);
        LightBounds turn = in_body;
        turn.box = {motion_->position_bounds().min + arm - around,
                    motion_->position_bounds().max + arm + around};
        turn.axis = rotate(orientation, in_body.axis);
        turn.spread = std::min(kPi, in_body.spread + turned.within);
        swept = swept.with(turn);
    }
    swept.strength = in_body.strength;
    return swept;
}

bool EmissiveObject::is_black() const {
    return visit([](const auto& shape) { return shape.is_black(); });
}

bool EmissiveObject::is_round() const {
    const EmissiveShape* shape = curved();
    return shape != nullptr && shape->is_round();
}

}  // namespace carom::render
