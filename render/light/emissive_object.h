// An object with an emissive material as a light, at rest or moving.
#pragma once

#include <memory>
#include <variant>

#include "render/geometry/rigid_motion.h"
#include "render/light/emissive_shape.h"
#include "render/light/emissive_surface.h"
#include "render/light/light_tree.h"

namespace carom::render {

/// The shape is described in the axes of the body that it follows; the light is sampled, and its
/// density computed, where the shape is at the path's own time (in [0, 1] of the shutter).
/// Immutable; copies share their data.
class EmissiveObject {
  public:
    explicit EmissiveObject(EmissiveSurface surface)
        : shape_(std::make_shared<const EmissiveSurface>(std::move(surface))) {}
    explicit EmissiveObject(const EmissiveShape& shape) : shape_(shape) {}

    /// The same object with the motion of its body; without one it is at rest.
    [[nodiscard]] EmissiveObject moving(std::shared_ptr<const RigidMotion> motion) const;

    [[nodiscard]] bool is_black() const;
    /// A sphere with three equal radii.
    [[nodiscard]] bool is_round() const;

    /// In the world's axes, wherever it moves.
    [[nodiscard]] LightBounds bounds() const;

    /// For kernels: the curved shape, or null if the faces are flat.
    [[nodiscard]] const EmissiveShape* curved() const {
        return std::get_if<EmissiveShape>(&shape_);
    }
    /// For kernels: the flat faces, or null if the shape is curved.
    [[nodiscard]] const EmissiveSurface* flat() const;
    /// Null at rest.
    [[nodiscard]] const RigidMotion* motion() const { return motion_.get(); }

  private:
    template <class Visitor>
    [[nodiscard]] auto visit(const Visitor& visitor) const {
        const EmissiveSurface* surface = flat();
        return surface != nullptr ? visitor(*surface) : visitor(*curved());
    }

    std::variant<std::shared_ptr<const EmissiveSurface>, EmissiveShape> shape_;
    std::shared_ptr<const RigidMotion> motion_;
};

}  // namespace carom::render
