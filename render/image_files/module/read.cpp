#include <OpenImageIO/imagebuf.h>

#include "render/image_files/module/format_functions.h"

namespace carom::render::formats {

RawPicture read(const std::string& path) {
    // Colours as stored, because the ignored alpha must not darken them.
    OIIO::ImageSpec wanted;
    wanted.attribute("oiio:UnassociatedAlpha", 1);
    OIIO::ImageBuf buffer(path, 0, 0, nullptr, &wanted);
    if (!buffer.init_spec(path, 0, 0)) {
        refuse_image(path, one_line(buffer.geterror()));
    }
    const OIIO::ImageSpec spec = buffer.spec();
    check_picture_size(path, spec.width, spec.height);
    if (spec.nchannels < 1) {
        refuse_image(path, "it has no channels");
    }
    RawPicture picture{
        spec.width, spec.height, spec.nchannels, spec.format.is_floating_point(), {}};
    if (!buffer.read(0, 0, true, OIIO::TypeDesc::FLOAT)) {
        refuse_image(path, one_line(buffer.geterror()));
    }
    picture.values.resize(static_cast<std::size_t>(spec.width) *
                          static_cast<std::size_t>(spec.height) *
                          static_cast<std::size_t>(spec.nchannels));
    if (!buffer.get_pixels(OIIO::get_roi(buffer.spec()), OIIO::TypeDesc::FLOAT,
                           picture.values.data())) {
        refuse_image(path, one_line(buffer.geterror()));
    }
    return picture;
}

}  // namespace carom::render::formats
