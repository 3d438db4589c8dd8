// The channels beside the picture: what was seen, not how bright it was.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "render/camera/thin_lens_camera.h"
#include "render/film/film.h"
#include "render/frame/frame.h"
#include "render/frame_scene/frame_scene.h"

namespace carom::render {

/// Z of pixels that see nothing, m.
inline constexpr float kFarDepth = 1e10f;

[[nodiscard]] bool is_aov(std::string_view name);

/// Means over a pixel's samples.
struct PixelMeans {
    V3f normal{0, 0, 0};
    V3f albedo{0, 0, 0};
    float variance = 0;  // of the mean luminance
};

/// Collects the channels that were asked for, one pixel at a time and from any thread:
///   depth      Z                 m along the optical axis; kFarDepth where nothing is
///   normal     N.X N.Y N.Z       world axes, towards the camera; mean over the samples
///   albedo     albedo.R .G .B    base colour; mean over the samples
///   motion     motion.X .Y       pixels (right, down) that the point moves from open to close
///   object_id  object_id         1 + index in the scene's objects, then its lights; 0: nothing
///   variance   variance          of the pixel's mean luminance, as if samples were independent
/// Depth, motion and object belong to what the pixel's centre sees through the centre of the lens
/// in the middle of the shutter: they have no noise and no mixed values.
class AovPlanes {
  public:
    AovPlanes(const RenderSettings& settings, const FrameInput& frame, const FrameScene& scene);

    [[nodiscard]] bool empty() const { return channels_.empty(); }

    void write(int x, int y, const PixelMeans& means);

    /// In the order of `settings.aovs`.
    [[nodiscard]] std::vector<Channel> take() { return std::move(channels_); }

  private:
    struct Seen {
        float depth = kFarDepth;
        V2f motion{0, 0};
        float object = 0;
    };

    [[nodiscard]] Seen look(int x, int y) const;
    [[nodiscard]] V2f motion_of(const V3f& at_open, const V3f& at_close) const;

    std::vector<std::string> names_;
    std::vector<Channel> channels_;
    const FrameScene& scene_;
    ThinLensCamera camera_;  // without a lens
    int width_;
    bool looks_ = false;
};

}  // namespace carom::render
