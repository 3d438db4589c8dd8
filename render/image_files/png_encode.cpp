#include <algorithm>
#include <exception>

#include <png.h>

#include "core/assert.h"
#include "core/error.h"
#include "render/image_files/png_error.h"
#include "render/image_files/png_file.h"

namespace carom::render {
namespace {

// With all filters, a third of the time of level 6, which is the usual one, and smaller files: 33
// ms and 268 kB for a noisy picture of 640 x 360 pixels, where level 6 takes 144 ms and 273 kB.
constexpr int kZlibLevel = 4;

void append_bytes(png_structp png, png_bytep bytes, std::size_t count) {
    auto* target = static_cast<std::vector<std::byte>*>(png_get_io_ptr(png));
    bool has_memory = true;
    try {
        const auto* start = reinterpret_cast<const std::byte*>(bytes);
        target->insert(target->end(), start, start + count);
    } catch (const std::exception&) {
        has_memory = false;
    }
    if (!has_memory) {
        png_error(png, "there is not enough memory");
    }
}

void flush_nothing(png_structp /*png*/) {}

bool is_ascii(const std::string& text) {
    return std::ranges::all_of(text, [](char letter) { return (letter & 0x80) == 0; });
}

std::vector<png_text> as_png_texts(const std::map<std::string, std::string>& texts) {
    std::vector<png_text> entries;
    for (const auto& [key, value] : texts) {
        const char* name = key == "ImageDescription" ? "Description" : key.c_str();
        png_text entry{};
        // tEXt contains Latin-1, iTXt contains UTF-8 (PNG Specification, 11.3.4).
        entry.compression = is_ascii(value) ? PNG_TEXT_COMPRESSION_NONE : PNG_ITXT_COMPRESSION_NONE;
        entry.key = const_cast<char*>(name);  // libpng copies both
        entry.text = const_cast<char*>(value.c_str());
        entries.push_back(entry);
    }
    return entries;
}

class Writer {
  public:
    explicit Writer(std::vector<std::byte>& target) {
        png_ = png_create_write_struct(PNG_LIBPNG_VER_STRING, &error_, stop_with_message,
                                       ignore_warning);
        info_ = png_ != nullptr ? png_create_info_struct(png_) : nullptr;
        if (info_ != nullptr) {
            png_set_write_fn(png_, &target, append_bytes, flush_nothing);
        }
    }
    ~Writer() { png_destroy_write_struct(&png_, &info_); }
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;

    [[nodiscard]] const char* error() const { return error_.text.data(); }

    /// Returns false after an error. libpng leaves it by longjmp, so that it must not have objects
    /// with destructors.
    bool write(png_uint_32 width, png_uint_32 height, std::size_t channels, png_const_bytep values,
               png_textp texts, int text_count) {
        if (info_ == nullptr || setjmp(png_jmpbuf(png_)) != 0) {
            return false;
        }
        png_set_IHDR(png_, info_, width, height, 8,
                     channels == 4 ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB,
                     PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
        png_set_sRGB_gAMA_and_cHRM(png_, info_, PNG_sRGB_INTENT_ABSOLUTE);
        png_set_compression_level(png_, kZlibLevel);
        png_set_compression_strategy(png_, PNG_Z_DEFAULT_STRATEGY);
        png_set_filter(png_, PNG_FILTER_TYPE_BASE, PNG_ALL_FILTERS);
        png_set_text(png_, info_, texts, text_count);
        png_write_info(png_, info_);
        for (png_uint_32 row = 0; row < height; ++row) {
            png_write_row(png_, values + channels * width * row);
        }
        png_write_end(png_, info_);
        return true;
    }

  private:
    PngError error_;
    png_structp png_ = nullptr;
    png_infop info_ = nullptr;
};

}  // namespace

std::vector<std::byte> encode_png(std::span<const std::uint8_t> values, int width, int height,
                                  const std::map<std::string, std::string>& texts) {
    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    const std::size_t channels = values.size() == 4 * pixels ? 4 : 3;
    CAROM_ASSERT(values.size() == channels * pixels);
    std::vector<png_text> entries = as_png_texts(texts);
    std::vector<std::byte> file;
    Writer writer(file);
    if (!writer.write(static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), channels,
                      values.data(), entries.data(), static_cast<int>(entries.size()))) {
        throw Error(writer.error());
    }
    return file;
}

}  // namespace carom::render
