#include <array>
#include <cstring>

#include <png.h>

#include "render/image_files/png_error.h"
#include "render/image_files/png_file.h"

namespace carom::render {
namespace {

/// Deflate compresses by less than this factor (RFC 1951: 258 bytes in two bits).
constexpr std::size_t kMostPacked = 1100;

/// What libpng reads from.
struct Source {
    std::span<const std::byte> rest;
    PngError error;
};

void read_bytes(png_structp png, png_bytep out, std::size_t count) {
    auto* source = static_cast<Source*>(png_get_io_ptr(png));
    if (count > source->rest.size()) {
        png_error(png, "the file ends too early");
    }
    std::memcpy(out, source->rest.data(), count);
    source->rest = source->rest.subspan(count);
}

class Reader {
  public:
    explicit Reader(std::span<const std::byte> bytes) {
        source_.rest = bytes;
        png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, &source_.error, stop_with_message,
                                      ignore_warning);
        info_ = png_ != nullptr ? png_create_info_struct(png_) : nullptr;
        if (info_ != nullptr) {
            png_set_read_fn(png_, &source_, read_bytes);
        }
    }
    ~Reader() { png_destroy_read_struct(&png_, &info_, nullptr); }
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;

    [[nodiscard]] const char* error() const { return source_.error.text.data(); }
    [[nodiscard]] long long width() const { return png_get_image_width(png_, info_); }
    [[nodiscard]] long long height() const { return png_get_image_height(png_, info_); }
    [[nodiscard]] int channels() const { return png_get_channels(png_, info_); }
    [[nodiscard]] bool has_16_bits() const { return png_get_bit_depth(png_, info_) == 16; }
    [[nodiscard]] std::size_t row_bytes() const { return png_get_rowbytes(png_, info_); }

    /// Both return false after an error. libpng leaves them by longjmp, so that they must not have
    /// objects with destructors.
    bool read_header() {
        if (info_ == nullptr || setjmp(png_jmpbuf(png_)) != 0) {
            return false;
        }
        png_read_info(png_, info_);
        // 8 or 16 bits a channel, palettes as RGB, and transparent colours as alpha.
        png_set_expand(png_);
        png_set_interlace_handling(png_);
        png_read_update_info(png_, info_);
        return true;
    }
    bool read_rows(png_bytepp rows) {
        if (setjmp(png_jmpbuf(png_)) != 0) {
            return false;
        }
        png_read_image(png_, rows);
        png_read_end(png_, nullptr);
        return true;
    }

  private:
    Source source_;
    png_structp png_ = nullptr;
    png_infop info_ = nullptr;
};

/// The values in [0, 1] of rows that follow each other. 16-bit values are big-endian.
std::vector<float> scaled(const std::vector<png_byte>& bytes, bool has_16_bits) {
    constexpr float kOne8 = 1.0f / 255;
    constexpr float kOne16 = 1.0f / 65535;
    std::vector<float> values;
    values.reserve(bytes.size() / (has_16_bits ? 2 : 1));
    if (has_16_bits) {
        for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
            values.push_back(static_cast<float>(bytes[i] << 8 | bytes[i + 1]) * kOne16);
        }
    } else {
        for (const png_byte byte : bytes) {
            values.push_back(static_cast<float>(byte) * kOne8);
        }
    }
    return values;
}

}  // namespace

bool is_png(std::string_view head) {
    return head.starts_with("\x89PNG\r\n\x1a\n");
}

RawPicture decode_png(std::span<const std::byte> bytes, const std::string& path) {
    Reader reader(bytes);
    if (!reader.read_header()) {
        refuse_image(path, reader.error());
    }
    check_picture_size(path, reader.width(), reader.height());
    RawPicture picture;
    picture.width = static_cast<int>(reader.width());
    picture.height = static_cast<int>(reader.height());
    picture.channels = reader.channels();
    const std::size_t rows = static_cast<std::size_t>(picture.height);
    if (rows * reader.row_bytes() / kMostPacked > bytes.size()) {
        refuse_image(path, "the file is too short for its pixels");
    }
    std::vector<png_byte> pixels(rows * reader.row_bytes());
    std::vector<png_bytep> starts(rows);
    for (std::size_t row = 0; row < rows; ++row) {
        starts[row] = &pixels[row * reader.row_bytes()];
    }
    if (!reader.read_rows(starts.data())) {
        refuse_image(path, reader.error());
    }
    picture.values = scaled(pixels, reader.has_16_bits());
    return picture;
}

}  // namespace carom::render
