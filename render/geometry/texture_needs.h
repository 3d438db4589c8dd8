// What textures need to know of a point. Plain, for kernels.
#pragma once

namespace carom::render {

/// Of a SurfacePoint: the place in the object's axes, uv with its gradients and lengths, the sides
/// of a pixel in the object's axes, and these axes, unless they are the world's.
struct TextureNeeds {
    bool position = false;
    bool uv = false;
    bool sides = false;
    bool axes = false;
};

}  // namespace carom::render
