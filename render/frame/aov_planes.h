// AOVs: the channels of a frame besides its colour.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "render/camera/thin_lens_camera.h"
#include "render/film/cryptomatte.h"
#include "render/film/film.h"
#include "render/frame/frame.h"
#include "render/frame_scene/frame_scene.h"

namespace carom::render {

/// Depth (Z, m) of pixels that see only background.
inline constexpr float kFarDepth = 1e10f;

[[nodiscard]] bool is_aov(std::string_view name);
/// Whether the channel contains mattes, which need the names of objects and materials.
[[nodiscard]] bool is_matte(std::string_view name);

/// Names of objects and materials by their indices in hits.
struct SceneNames {
    std::vector<std::string> objects;  // followed by the area lights
    std::vector<std::string> materials;
    std::vector<std::uint32_t> material_of;  // by object; for lights, beyond all materials
};

struct ObjectCount {
    std::uint32_t object = 0;
    std::uint32_t samples = 0;
};

/// Means over a pixel's samples.
struct PixelMeans {
    std::span<const ObjectCount> objects;  // hit, and by how many of `samples`
    int samples = 1;
    V3f normal{0, 0, 0};
    V3f albedo{0, 0, 0};
    float roughness = 0;
    float variance = 0;  // of the mean luminance, if samples were independent
    /// ((A - B) / 2)^2, where A and B are the mean luminances of the halves of the samples: the
    /// variance of the mean, if the halves are independent.
    float squared_difference = 0;
};

/// Collects the requested channels, one pixel at a time and from any thread:
///   depth      Z                 m along the optical axis; kFarDepth for the background
///   normal     N.X N.Y N.Z       world axes, towards the camera; mean over the samples
///   albedo     albedo.R .G .B    base colour; mean over the samples
///   roughness  roughness.X       of what is below the coat, [0, 1]; mean over the samples
///   motion     motion.X .Y       pixels (right, down) that the point moves from open to close
///   object_id  object_id.X       1 + index in the scene's objects, then its lights; 0: background
///   material_id material_id.X    1 + index in the scene's materials; 0: background, or a light
///   variance   variance.X        of the pixel's mean luminance. If the samples are taken in
///   halves,
///                                these are compared (finish_variance); if not, as if samples were
///                                independent, which is two to eight times too much. Of splats as
///                                in splat_moments.h
///   cryptomatte_object, cryptomatte_material
///              CryptoObject00.R ... mattes by the names of objects and materials (cryptomatte.h)
/// Depth, motion, object and material are those that the pixel's centre sees through the centre of
/// the lens in the middle of the shutter: they have neither noise nor mixed values.
class AovPlanes {
  public:
    AovPlanes(const RenderSettings& settings, const FrameInput& frame, const FrameScene& scene,
              const SceneNames& names);

    [[nodiscard]] bool empty() const { return channels_.empty(); }

    /// Whether `write` needs to know which objects a pixel's samples hit.
    [[nodiscard]] bool needs_objects() const { return !notes_.empty(); }

    void write(int x, int y, const PixelMeans& means);

    /// Whether the variance is among the channels.
    [[nodiscard]] bool has_variance() const;
    /// Finishes the variance, if it is among the channels, once all pixels are written; from one
    /// thread. The difference of a pixel's halves alone says little, and samples that are
    /// well distributed deviate less than independent ones, by a factor that changes slowly over
    /// the picture: this factor is measured in 17x17 pixels. `more`: the variance of light that
    /// pixels do not sample themselves, row by row.
    void finish_variance(const std::vector<float>& more);

    /// The channels in the order of `settings.aovs`.
    [[nodiscard]] std::vector<Channel> take() { return std::move(channels_); }
    [[nodiscard]] Film::Notes take_notes() { return std::move(notes_); }

  private:
    struct CentreHit {
        float depth = kFarDepth;
        V2f motion{0, 0};
        float object = 0;
        float material = 0;
    };

    [[nodiscard]] std::vector<std::string> add_matte(std::string_view name);
    [[nodiscard]] CentreHit trace_centre(int x, int y) const;
    [[nodiscard]] MatteRanks ranks(const PixelMeans& means, const std::vector<float>& ids) const;
    [[nodiscard]] V2f motion_of(const V3f& at_open, const V3f& at_close) const;

    std::vector<std::string> names_;
    const SceneNames& scene_names_;
    std::vector<float> object_ids_;    // for Cryptomatte, by object
    std::vector<float> material_ids_;  // for Cryptomatte, of the object's material
    Film::Notes notes_;
    std::vector<Channel> channels_;
    std::vector<float> squared_differences_;  // of halves, for the variance
    const FrameScene& scene_;
    ThinLensCamera camera_;  // without a lens
    int width_;
    bool needs_centre_ray_ = false;
};

}  // namespace carom::render
