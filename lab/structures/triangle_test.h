// The test of a ray and a triangle inside a structure, if another one than the renderer's is asked
// for.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include "render/geometry/ray.h"

namespace carom::render {

class TriangleTest {
  public:
    TriangleTest() = default;
    virtual ~TriangleTest() = default;
    TriangleTest(const TriangleTest&) = delete;
    TriangleTest& operator=(const TriangleTest&) = delete;

    /// Sets the distance and the weights of `hit` if the ray hits the triangle in (t_min, t_max).
    [[nodiscard]] virtual bool closest(std::size_t triangle, const Ray& ray, Hit& hit) const = 0;
};

/// Prepares the test of these triangles, given by their corners.
using TriangleTestMaker = std::function<std::shared_ptr<const TriangleTest>(
    const std::vector<std::array<V3f, 3>>& triangles)>;

}  // namespace carom::render
