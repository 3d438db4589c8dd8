// Colour pictures from files, in linear light.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "render/geometry/ray.h"
#include "render/image_files/read_picture.h"
#include "render/texture/mip_pyramid.h"

namespace carom::render {

/// width * height linear Rec.709 colours, row by row from the top left.
struct LinearImage {
    int width = 0;
    int height = 0;
    std::vector<V3f> pixels;
    std::size_t clamped = 0;      // pixels with a negative, infinite or undefined value in the file
    std::size_t transparent = 0;  // pixels through which the background is seen
};

/// Reads any format of render/image_files/read_picture.h. Grey pictures become colours, which are
/// pixel_light (render/image_files/picture_light.h) over the background. Throws Error with the
/// file's name if it is unreadable or too large.
[[nodiscard]] LinearImage read_linear_image(const std::string& path, bool is_linear,
                                            const V3f& background = V3f(0));

/// A colour and its alpha.
using ColourWithAlpha = Imath::Vec4<float>;

/// Half-float storage: 8 bytes per texel.
struct HalfColourCodec {
    struct Texel {
        std::uint16_t r, g, b, alpha;
    };
    using Value = ColourWithAlpha;
    static Value decode(const Texel& texel);
    static Texel encode(const Value& value);
};

using ColourPyramid = MipPyramid<HalfColourCodec>;

/// A half-float number: 2 bytes per texel.
struct HalfNumberCodec {
    using Texel = std::uint16_t;
    using Value = float;
    static Value decode(Texel texel) { return scalar::half_value<scalar::One>(texel); }
    static Texel encode(Value value);
};

/// The levels of a picture that repeats. Grey stays grey, and opaque integers of 8 or 16 bits stay
/// what they are in the finest level: there a table has the half-float light that each means. All
/// else are half floats. Colours of pictures with alpha are multiplied by it.
class ImagePyramid {
  public:
    /// `picture`: of which fits() is true.
    ImagePyramid(RawPicture picture, bool is_linear);

    /// Whether kernels reach all of its levels.
    [[nodiscard]] static bool fits(const RawPicture& picture);

    /// For kernels; valid as long as this object is.
    [[nodiscard]] ImageTables tables() const;
    [[nodiscard]] bool has_alpha() const { return has_alpha_; }

  private:
    [[nodiscard]] std::size_t place(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
               static_cast<std::size_t>(x);
    }
    template <class Codec>
    [[nodiscard]] MipPyramid<Codec> levels_behind(const RawPicture& picture) const;

    int width_;
    int height_;
    PictureValues codes_;        // numbers, of which there are none, if the finest level has none
    std::vector<float> values_;  // of the codes
    std::variant<ColourPyramid, MipPyramid<HalfNumberCodec>> levels_;
    bool has_alpha_;
};

/// Throws Error, with the path, if kernels do not reach all of the picture.
void check_fits(const std::string& path, const RawPicture& picture, bool fits);

/// How pictures come from files: as read_picture, or already known.
using ReadPicture = std::function<RawPicture(const std::string& path)>;

/// An alpha that is 1 all over does not count. Throws Error if the file cannot be read or does not
/// fit.
[[nodiscard]] std::shared_ptr<const ImagePyramid> load_image_pyramid(
    const std::string& path, bool is_linear, const ReadPicture& read = read_picture);

}  // namespace carom::render
