// Contacts between boxes, and between boxes and triangle surfaces, from ODE's collision routines.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/pose.h"

namespace carom::sim::ode {

struct BoxContact {
    Vec3 point{0, 0, 0};
    Vec3 normal{0, 0, 1};  // unit, from the second towards the first
    double depth = 0;
};

/// Gaps up to this (m) between boxes count as contacts of negative depth, so that a stack keeps all
/// four corners of every face in contact.
inline constexpr double kBoxMargin = 1e-4;

/// Up to four contacts of two boxes.
void collide_boxes(const Vec3& size_a, const Pose& a, const Vec3& size_b, const Pose& b,
                   std::vector<BoxContact>& contacts);

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
    void collide(const Vec3& size, const Pose& box, std::vector<BoxContact>& contacts) const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace carom::sim::ode
