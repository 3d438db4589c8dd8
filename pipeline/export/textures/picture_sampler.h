// Colours of a picture at any place.
#pragma once

#include <memory>
#include <vector>

#include "core/vectors.h"
#include "render/image_files/raw_picture.h"

namespace carom::pipeline {

/// Reads between pixels, linearly; the picture repeats.
class PictureSampler {
  public:
    /// `is_linear`: as pixel_light has it (render/image_files/picture_light.h).
    PictureSampler(std::shared_ptr<const render::RawPicture> picture, bool is_linear);

    struct Texel {
        Imath::V3f colour{0, 0, 0};  // linear, multiplied by alpha
        float alpha = 1;
    };
    /// From (0, 0) at the lower left to (1, 1) at the upper right.
    [[nodiscard]] Texel at(const Vec2& place) const;

  private:
    [[nodiscard]] Texel pixel(int x, int y) const;  // y down; repeats

    std::shared_ptr<const render::RawPicture> picture_;
    bool is_linear_;
    std::vector<float> codes_;  // what each code of 8 bits means; empty for other pictures
};

}  // namespace carom::pipeline
