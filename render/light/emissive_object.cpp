#include "render/light/emissive_object.h"

#include <utility>

#include "render/light/scalar_kernels.h"

namespace carom::render {
namespace {

/// Where a body is; the orientation of a round one does not matter.
class BodyAxes {
  public:
    BodyAxes(const RigidMotion* motion, bool is_round, float time) : moves_(motion != nullptr) {
        if (moves_) {
            position_ = motion->position(time);
            turns_ = !is_round;
            if (turns_) {
                turn_ = motion->world_from_body(time);
            }
        }
    }

    [[nodiscard]] V3f point(const V3f& world) const {
        return moves_ ? vector(world - position_) : world;
    }
    [[nodiscard]] V3f vector(const V3f& world) const {
        return turns_ ? rotate_back(turn_, world) : world;
    }

  private:
    bool moves_ = false;
    bool turns_ = false;
    V3f position_{0, 0, 0};
    Imath::Quatf turn_{};
};

}  // namespace

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

float EmissiveObject::pdf(const V3f& point, const V3f& direction, float distance, const V3f& normal,
                          float time) const {
    if (const EmissiveSurface* surface = flat()) {
        return surface->pdf(distance, -direction.dot(normal));
    }
    const BodyAxes body(motion_.get(), is_round(), time);
    return curved()->pdf(body.point(point), body.vector(direction), distance, body.vector(normal));
}

float EmissiveObject::importance(const V3f& point, const V3f& normal, float time) const {
    const BodyAxes body(motion_.get(), is_round(), time);
    return visit([&](const auto& shape) {
        return shape.importance(body.point(point), body.vector(normal));
    });
}

}  // namespace carom::render
