// The sums of a frame as the denoiser reads them. Internal to this folder.
#pragma once

#include <cstddef>
#include <vector>

#include "render/denoise/denoise.h"
#include "render/frame/denoiser_planes.h"
#include "render/frame/frame_part.h"
#include "render/frame/splat_picture.h"
#include "render/frame/tile_renderer.h"
#include "render/frame/tile_sums.h"

namespace carom::render {

/// What the denoiser reads of the part's pixels, and of the images of lights in balls, if any: one
/// picture of each half. Everything is borrowed.
class DenoiserRows final : public DenoiseSource {
  public:
    DenoiserRows(const FramePart& part, const TileRenderer& tiles,
                 const std::vector<TileSums>& sums, const std::vector<SplatPicture>& pictures)
        : part_(part), tiles_(tiles), sums_(sums), pictures_(pictures) {}

    [[nodiscard]] DenoiseShape shape() const override;
    void colours(int y, const ColourRows& rows) const override;
    void features(int y, const FeatureRows& rows) const override;

  private:
    template <class Use>
    void for_pixels(int y, const Use& use) const;
    void write_colour(int x, int y, const DenoiserPixel& pixel, const DenoiserValues& values,
                      std::size_t i, const ColourRows& rows) const;

    const FramePart& part_;
    const TileRenderer& tiles_;
    const std::vector<TileSums>& sums_;
    const std::vector<SplatPicture>& pictures_;
};

}  // namespace carom::render
