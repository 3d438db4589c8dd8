#include "render/light/emissive_object.h"

#include <utility>

#include "render/light/scalar_kernels.h"

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

scalar::BodyOf<scalar::One> EmissiveObject::body_at(float time) const {
    const MotionPieces motion = motion_ ? motion_->pieces() : MotionPieces();
    return scalar::body_at<scalar::One>(motion, is_round(), time);
}

float EmissiveObject::pdf(const V3f& point, const V3f& direction, float distance, const V3f& normal,
                          float time) const {
    if (const EmissiveSurface* surface = flat()) {
        return surface->pdf(distance, -direction.dot(normal));
    }
    const auto body = body_at(time);
    return curved()->pdf(body.point(point), body.vector(direction), distance, body.vector(normal));
}

float EmissiveObject::importance(const V3f& point, const V3f& normal, float time) const {
    const auto body = body_at(time);
    return visit([&](const auto& shape) {
        return shape.importance(body.point(point), body.vector(normal));
    });
}

}  // namespace carom::render
