#include "render/film/ocio_view.h"

#include "core/assert.h"
#include "render/image_files/format_module.h"

namespace carom::render {

OcioView::OcioView(const std::string& path, const OcioNames& names)
    : transform_(
          format_module().make_transform(path, {names.display, names.view, names.colour_space})) {}

OcioView::~OcioView() = default;
OcioView::OcioView(OcioView&&) noexcept = default;
OcioView& OcioView::operator=(OcioView&&) noexcept = default;

void OcioView::apply(std::vector<float>& rgb, int width, int height) const {
    CAROM_ASSERT(rgb.size() ==
                 3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    transform_->apply(rgb, width, height);
}

}  // namespace carom::render
