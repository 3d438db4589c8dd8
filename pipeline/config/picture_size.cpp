#include "pipeline/config/picture_size.h"

#include <algorithm>
#include <cmath>

namespace carom::pipeline::config {

namespace {

int nearest_even(double value) {
    return 2 * static_cast<int>(std::lround(value / 2));
}

}  // namespace

PictureSize scaled_to_short_side(const PictureSize& shape, int short_side) {
    const double scale =
        static_cast<double>(short_side) / static_cast<double>(std::min(shape.width, shape.height));
    return {nearest_even(shape.width * scale), nearest_even(shape.height * scale)};
}

}  // namespace carom::pipeline::config
