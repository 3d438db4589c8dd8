// Contacts between boxes, and between boxes and triangle surfaces, from ODE's collision routines.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/pose.h"
#include "sim/motion/contact.h"

namespace carom::sim::ode {

/// Up to four contacts of two boxes with gaps up to `margin`, with normals from b towards a.
void collide_boxes(const Vec3& size_a, const Pose& a, const Vec3& size_b, const Pose& b,
                   double margin, std::vector<Contact>& contacts);

/// A triangle surface for collisions with boxes. ODE's triangle code keeps process-wide state in
/// Debian's build, so all calls share one lock.
class TriangleSurface {
  public:
    TriangleSurface(const std::vector<Vec3>& vertices,
                    const std::vector<std::array<std::uint32_t, 3>>& triangles);
    ~TriangleSurface();
    TriangleSurface(TriangleSurface&&) noexcept;
    TriangleSurface& operator=(TriangleSurface&&) = delete;
    TriangleSurface(const TriangleSurface&) = delete;
    TriangleSurface& operator=(const TriangleSurface&) = delete;

    /// Up to eight contacts, normals towards the box.
    void collide(const Vec3& size, const Pose& box, std::vector<Contact>& contacts) const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace carom::sim::ode
