// Where the kernels of one ray and one triangle divide.
#pragma once

namespace carom::render::triangle {

/// Which denominator comes when: divided by at once, or after all tests, which then compare
/// multiples and divide for hits only.
enum class Division { early, deferred };

}  // namespace carom::render::triangle
