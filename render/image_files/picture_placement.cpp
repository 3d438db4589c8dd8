#include "render/image_files/picture_placement.h"

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <utility>

namespace carom::render {
namespace {

bool is_known(Orientation orientation) {
    return orientation >= 1 && orientation <= 8;
}

/// Whether stored rows are columns of the picture.
bool swaps_axes(Orientation orientation) {
    return is_known(orientation) && orientation >= 5;
}

/// Reads numbers of a TIFF file in its byte order. Positions outside of the data give 0.
class TiffNumbers {
  public:
    explicit TiffNumbers(std::span<const std::byte> bytes)
        : bytes_(bytes), is_little_(at(0) == 'I') {}

    [[nodiscard]] bool is_valid() const {
        return bytes_.size() >= 8 && (at(0) == 'I' || at(0) == 'M') && at(1) == at(0) &&
               number(2, 2) == 42;
    }
    [[nodiscard]] std::uint32_t number(std::size_t position, std::size_t size) const {
        std::uint32_t value = 0;
        for (std::size_t i = 0; i < size; ++i) {
            const std::size_t place = is_little_ ? i : size - 1 - i;
            value |= std::uint32_t{at(position + i)} << (8 * place);
        }
        return value;
    }

  private:
    [[nodiscard]] std::uint8_t at(std::size_t position) const {
        return position < bytes_.size() ? static_cast<std::uint8_t>(bytes_[position]) : 0;
    }

    std::span<const std::byte> bytes_;
    bool is_little_;
};

/// The values of a picture that becomes `width` pixels wide.
template <class Value>
std::vector<Value> values_turned(const std::vector<Value>& values, const RawPicture& picture,
                                 int width, Orientation orientation) {
    const auto is_one_of = [orientation](std::initializer_list<Orientation> numbers) {
        return std::ranges::find(numbers, orientation) != numbers.end();
    };
    // Whether the first row is at the bottom or right, and the first column at the right or bottom.
    const bool are_rows_reversed = is_one_of({3, 4, 6, 7});
    const bool are_columns_reversed = is_one_of({2, 3, 7, 8});
    const auto channels = static_cast<std::size_t>(picture.channels);
    std::vector<Value> result(values.size());
    const Value* from = values.data();
    for (int row = 0; row < picture.height; ++row) {
        const int r = are_rows_reversed ? picture.height - 1 - row : row;
        for (int column = 0; column < picture.width; ++column, from += channels) {
            const int c = are_columns_reversed ? picture.width - 1 - column : column;
            const auto [x, y] = swaps_axes(orientation) ? std::pair(r, c) : std::pair(c, r);
            const std::size_t pixel =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                static_cast<std::size_t>(x);
            std::copy_n(from, channels, &result[pixel * channels]);
        }
    }
    return result;
}

}  // namespace

PictureSize turned(PictureSize size, Orientation orientation) {
    return swaps_axes(orientation) ? PictureSize{size.height, size.width} : size;
}

RawPicture turned(RawPicture picture, Orientation orientation) {
    if (!is_known(orientation) || orientation == kUpright) {
        return picture;
    }
    const auto [width, height] = turned(PictureSize{picture.width, picture.height}, orientation);
    picture.values = std::visit(
        [&](const auto& values) {
            return PictureValues(values_turned(values, picture, width, orientation));
        },
        picture.values);
    picture.width = width;
    picture.height = height;
    return picture;
}

// Exif is stored like a TIFF file: a list of tags of twelve bytes each (TIFF 6.0, section 2).
Orientation exif_orientation(std::span<const std::byte> exif) {
    constexpr std::uint32_t kOrientationTag = 0x0112;
    constexpr std::uint32_t kShort = 3;
    constexpr std::size_t kTagBytes = 12;
    constexpr std::string_view kMarker("Exif\0\0", 6);  // of JPEG files, which some programs copy
    const std::string_view text(reinterpret_cast<const char*>(exif.data()), exif.size());
    exif = exif.subspan(text.starts_with(kMarker) ? kMarker.size() : 0);
    const TiffNumbers tiff(exif);
    if (!tiff.is_valid()) {
        return kUpright;
    }
    const std::size_t list = tiff.number(4, 4);
    const std::size_t count = tiff.number(list, 2);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t tag = list + 2 + i * kTagBytes;
        if (tag + kTagBytes <= exif.size() && tiff.number(tag, 2) == kOrientationTag) {
            const bool is_short = tiff.number(tag + 2, 2) == kShort;
            const auto value = static_cast<Orientation>(tiff.number(tag + 8, is_short ? 2 : 4));
            return is_known(value) ? value : kUpright;
        }
    }
    return kUpright;
}

RawPicture within_display(RawPicture picture, const PixelWindow& data, const PixelWindow& display) {
    if (data == display) {
        return picture;
    }
    const auto channels = static_cast<std::size_t>(picture.channels);
    const auto index = [channels](const PixelWindow& window, int x, int y) {
        return static_cast<std::size_t>((static_cast<long long>(y) - window.top) * window.width() +
                                        (static_cast<long long>(x) - window.left)) *
               channels;
    };
    const auto& stored = std::get<std::vector<float>>(picture.values);
    std::vector<float> values(static_cast<std::size_t>(display.width() * display.height()) *
                              channels);
    const int left = std::max(data.left, display.left);
    const int right = std::min(data.right, display.right);
    for (int y = std::max(data.top, display.top); y <= std::min(data.bottom, display.bottom); ++y) {
        if (left <= right) {
            std::copy_n(
                &stored[index(data, left, y)],
                static_cast<std::size_t>(static_cast<long long>(right) - left + 1) * channels,
                &values[index(display, left, y)]);
        }
    }
    picture.width = static_cast<int>(display.width());
    picture.height = static_cast<int>(display.height());
    picture.values = std::move(values);
    return picture;
}

void check_windows(const std::string& path, const PixelWindow& data, const PixelWindow& display) {
    check_picture_size(path, data.width(), data.height());
    check_picture_size(path, display.width(), display.height());
    if (data.left > display.right || data.right < display.left || data.top > display.bottom ||
        data.bottom < display.top) {
        refuse_image(
            path, "its data window lies outside of its display window, so that it shows nothing");
    }
}

}  // namespace carom::render
