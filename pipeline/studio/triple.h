// Vectors as messages have them.
#pragma once

#include "core/vectors.h"
#include "pipeline/studio/messages.h"

namespace carom::studio {

[[nodiscard]] inline Triple triple(const Vec3& v) {
    return {v.x, v.y, v.z};
}

}  // namespace carom::studio
