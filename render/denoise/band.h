// Denoises some rows of a picture. Internal to this folder.
#pragma once

#include "render/denoise/band_planes.h"
#include "render/denoise/denoise.h"
#include "render/denoise/denoise_kernels.h"

namespace carom::render {

/// Rows beyond the band, as far as it looks at them, are computed with it; so its result depends on
/// the picture alone. Work is shared by the threads of the caller's arena. The source must outlive
/// the band.
class Band {
  public:
    Band(const DenoiseSource& source, const RowRange& rows);

    /// Sets the band's rows of the result, which has the size of the picture; without room for
    /// colours, only their error.
    void denoise(DenoisedPicture& result);

  private:
    void copy_colours(int y);
    void copy_features(int y);
    void estimate_variance(int y);
    void estimate_errors(int y);
    void compare_errors(int y);
    void write(int y, DenoisedPicture& result) const;
    void box_mean(const Plane& plane, int y, int radius, float* mean) const;
    [[nodiscard]] bool has_shape() const { return shape_.has_variance; }

    const DenoiseSource& source_;
    DenoiseShape shape_;
    const DenoiseKernels& kernels_;
    BandPlanes planes_;
};

}  // namespace carom::render
