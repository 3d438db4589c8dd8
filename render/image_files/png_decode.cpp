#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <optional>
#include <utility>

#include <png.h>

#include "render/image_files/picture_placement.h"
#include "render/image_files/png_error.h"
#include "render/image_files/png_file.h"

namespace carom::render {
namespace {

/// Deflate compresses by less than this factor (RFC 1951: 258 bytes in two bits).
constexpr std::size_t kMostPacked = 1100;

constexpr std::array<png_byte, 5> kCodePoints{'c', 'I', 'C', 'P', 0};

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
            png_set_keep_unknown_chunks(png_, PNG_HANDLE_CHUNK_ALWAYS, kCodePoints.data(), 1);
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
    /// After read_rows, because the data may follow the pixels.
    [[nodiscard]] Orientation orientation() const {
        png_bytep data = nullptr;
        png_uint_32 size = 0;
        return png_get_eXIf_1(png_, info_, &size, &data) != 0
                   ? exif_orientation(std::as_bytes(std::span(data, size)))
                   : kUpright;
    }
    /// The code of the transfer function in the chunk cICP (ITU-T H.273, table 3), if it has one.
    [[nodiscard]] std::optional<int> transfer_code() const {
        png_unknown_chunkp chunks = nullptr;
        const int count = png_get_unknown_chunks(png_, info_, &chunks);
        for (int i = 0; i < count; ++i) {
            if (std::memcmp(chunks[i].name, kCodePoints.data(), 4) == 0 && chunks[i].size == 4) {
                return chunks[i].data[1];
            }
        }
        return std::nullopt;
    }
    [[nodiscard]] std::span<const std::byte> colour_profile() const {
        png_charp name = nullptr;
        int compression = 0;
        png_bytep data = nullptr;
        png_uint_32 size = 0;
        return png_get_iCCP(png_, info_, &name, &compression, &data, &size) != 0
                   ? std::as_bytes(std::span(data, size))
                   : std::span<const std::byte>();
    }
    [[nodiscard]] bool is_srgb() const { return png_get_valid(png_, info_, PNG_INFO_sRGB) != 0; }
    /// The exponent by which the values were made from light, if it has one.
    [[nodiscard]] std::optional<double> encoding_exponent() const {
        double exponent = 0;
        return png_get_gAMA(png_, info_, &exponent) != 0 ? std::optional(exponent) : std::nullopt;
    }
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
        if constexpr (std::endian::native == std::endian::little) {
            png_set_swap(png_);
        }
        png_set_interlace_handling(png_);
        png_read_update_info(png_, info_);
        return true;
    }
    bool read_rows(png_bytepp rows) {
        if (setjmp(png_jmpbuf(png_)) != 0) {
            return false;
        }
        png_read_image(png_, rows);
        png_read_end(png_, info_);
        return true;
    }

  private:
    Source source_;
    png_structp png_ = nullptr;
    png_infop info_ = nullptr;
};

/// A number of a colour profile, which is big-endian; 0 outside of it.
std::uint32_t profile_number(std::span<const std::byte> profile, std::size_t at, std::size_t size) {
    std::uint32_t value = 0;
    for (std::size_t i = at; i < at + size && i < profile.size(); ++i) {
        value = value << 8U | static_cast<std::uint32_t>(profile[i]);
    }
    return value;
}

constexpr std::uint32_t signature(const char (&letters)[5]) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        value = value << 8U | static_cast<std::uint8_t>(letters[i]);
    }
    return value;
}

/// The exponent of the curve of red or grey in a profile (ICC.1:2022, 7.3, 10.6 and 10.18); 0 if it
/// has another curve.
double profile_gamma(std::span<const std::byte> profile) {
    constexpr std::size_t kTags = 128;  // after the head
    constexpr std::size_t kTagBytes = 12;
    const std::size_t count = profile_number(profile, kTags, 4);
    for (std::size_t i = 0; i < count && kTags + 4 + i * kTagBytes < profile.size(); ++i) {
        const std::size_t tag = kTags + 4 + i * kTagBytes;
        const std::uint32_t name = profile_number(profile, tag, 4);
        if (name != signature("rTRC") && name != signature("kTRC")) {
            continue;
        }
        const std::size_t curve = profile_number(profile, tag + 4, 4);
        const std::uint32_t kind = profile_number(profile, curve, 4);
        const std::uint32_t points = profile_number(profile, curve + 8, 4);
        if (kind == signature("curv") && points <= 1) {
            return points == 0 ? 1 : profile_number(profile, curve + 12, 2) / 256.0;
        }
        const bool is_power =
            kind == signature("para") && profile_number(profile, curve + 8, 2) == 0;
        return is_power ? profile_number(profile, curve + 12, 4) / 65536.0 : 0;
    }
    return 0;
}

/// The rows become the picture's values where they are to stay: pictures can be large. False after
/// an error.
template <class Value>
bool read_values(Reader& reader, RawPicture& picture) {
    std::vector<Value> values;
    values.reserve(picture.value_count() + kReadBeyond);
    values.resize(picture.value_count());
    const auto height = static_cast<std::size_t>(picture.height);
    std::vector<png_bytep> starts(height);
    for (std::size_t row = 0; row < height; ++row) {
        starts[row] = reinterpret_cast<png_bytep>(&values[row * (values.size() / height)]);
    }
    const bool is_read = reader.read_rows(starts.data());
    picture.values = std::move(values);
    return is_read;
}

/// As RawPicture has it. Throws Error for codes of light that sRGB is no approximation of.
float gamma_of(const Reader& reader, const std::string& path) {
    if (const std::optional<int> code = reader.transfer_code()) {
        constexpr int kGamma28 = 5;
        constexpr int kLinear = 8;
        constexpr int kPerceptualQuantizer = 16;
        constexpr int kHybridLogGamma = 18;
        if (*code == kPerceptualQuantizer || *code == kHybridLogGamma) {
            refuse_image(path,
                         "its colours are for displays with high dynamic range (cICP), which "
                         "are not read; convert it to OpenEXR");
        }
        return known_gamma(*code == kLinear ? 1 : *code == kGamma28 ? 2.8 : 0);
    }
    if (const std::span<const std::byte> profile = reader.colour_profile(); !profile.empty()) {
        return known_gamma(profile_gamma(profile));
    }
    const std::optional<double> exponent = reader.encoding_exponent();
    return !reader.is_srgb() && exponent && *exponent > 0 ? known_gamma(1 / *exponent) : 0;
}

}  // namespace

bool is_png(std::string_view head) {
    return head.starts_with("\x89PNG\r\n\x1a\n");
}

PictureSize png_size(std::span<const std::byte> bytes, const std::string& path) {
    Reader reader(bytes);
    if (!reader.read_header()) {
        refuse_image(path, reader.error());
    }
    check_picture_size(path, reader.width(), reader.height());
    return turned(PictureSize{static_cast<int>(reader.width()), static_cast<int>(reader.height())},
                  reader.orientation());
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
    const bool is_read = reader.has_16_bits() ? read_values<std::uint16_t>(reader, picture)
                                              : read_values<std::uint8_t>(reader, picture);
    if (!is_read) {
        refuse_image(path, reader.error());
    }
    picture.gamma = gamma_of(reader, path);
    return turned(std::move(picture), reader.orientation());
}

}  // namespace carom::render
