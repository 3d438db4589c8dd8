// Reuse of a random number after a discrete choice.
#pragma once

#include "render/sampling/scalar_kernels.h"

namespace carom::render {

/// `u` in [0, 1) has chosen between a part of size `probability` (u < probability) and the rest:
/// returns its position within the chosen part, remapped to [0, 1). Stratified numbers stay
/// stratified (Shirley 1990, "Physically based lighting calculations for computer graphics"; PBR,
/// section A.1).
[[nodiscard]] inline float remap_sample(float u, float probability) {
    return scalar::remap_sample<scalar::One>(u, probability);
}

}  // namespace carom::render
