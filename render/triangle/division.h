// When the kernels of one ray and one triangle divide.
#pragma once

namespace carom::render::triangle {

/// `early` divides before the tests; `deferred` compares multiples in the tests and divides for
/// hits only.
enum class Division { early, deferred };

}  // namespace carom::render::triangle
