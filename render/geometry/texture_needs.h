// What textures need to know of a point. Plain, for kernels.
#pragma once

namespace carom::render {

/// Of a SurfacePoint: the place in the object's axes, uv with its gradients and lengths, and the
/// object's axes.
struct TextureNeeds {
    bool position = false;
    bool uv = false;
    bool axes = false;
};

}  // namespace carom::render
