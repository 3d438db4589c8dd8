#include "render/image_files/radiance_file.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include <fmt/core.h>

namespace carom::render {
namespace {

constexpr int kNarrowestPacked = 8;    // pixels; narrower rows are not compressed
constexpr int kWidestPacked = 0x7fff;  // the row's head has 15 bits for the width
constexpr int kExponentOffset = 136;   // 128, and the 8 bits of a mantissa
constexpr std::size_t kComponents = 4;
constexpr std::size_t kLongestRun = 127;

/// Takes lines and bytes from the front of the file.
class Source {
  public:
    explicit Source(std::span<const std::byte> bytes)
        : rest_(reinterpret_cast<const char*>(bytes.data()), bytes.size()) {}

    /// The text up to the next line break; empty at the end.
    std::string_view line() {
        const std::size_t end = std::min(rest_.find('\n'), rest_.size());
        const std::string_view text = rest_.substr(0, end);
        rest_.remove_prefix(std::min(end + 1, rest_.size()));
        return text;
    }
    [[nodiscard]] std::size_t remaining() const { return rest_.size(); }
    [[nodiscard]] std::uint8_t peek(std::size_t at) const {
        return static_cast<std::uint8_t>(rest_[at]);
    }
    /// Only if as many remain.
    std::string_view take(std::size_t count) {
        const std::string_view taken = rest_.substr(0, count);
        rest_.remove_prefix(count);
        return taken;
    }

  private:
    std::string_view rest_;
};

/// Width and height from "-Y 256 +X 512"; empty for other orders of rows and columns.
std::optional<std::pair<int, int>> size_in(std::string_view line) {
    int width = 0;
    int height = 0;
    const auto number = [&line](std::string_view before, int& value) {
        if (!line.starts_with(before)) {
            return false;
        }
        line.remove_prefix(before.size());
        const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), value);
        line.remove_prefix(static_cast<std::size_t>(end - line.data()));
        return error == std::errc();
    };
    const bool is_usual = number("-Y ", height) && number(" +X ", width) && line.empty();
    return is_usual ? std::optional(std::pair(width, height)) : std::nullopt;
}

/// The size of a picture whose header says that it is of the usual kind.
std::optional<std::pair<int, int>> read_header(Source& source) {
    bool has_format = false;
    for (std::string_view line = source.line(); !line.empty(); line = source.line()) {
        has_format = has_format || line == "FORMAT=32-bit_rle_rgbe";
    }
    return has_format ? size_in(source.line()) : std::nullopt;
}

bool begins_packed_row(const Source& source, int width) {
    return source.remaining() >= kComponents && source.peek(0) == 2 && source.peek(1) == 2 &&
           (source.peek(2) << 8 | source.peek(3)) == width;
}

/// One component of a row: runs of one value, and values one by one. False if it is damaged.
bool unpack(Source& source, std::span<std::uint8_t> out) {
    constexpr std::size_t kLongestSingle = 128;
    while (!out.empty()) {
        if (source.remaining() < 2) {
            return false;
        }
        const std::size_t code = static_cast<std::uint8_t>(source.take(1).front());
        const bool is_run = code > kLongestSingle;
        const std::size_t count = is_run ? code - kLongestSingle : code;
        if (count == 0 || count > out.size() || source.remaining() < (is_run ? 1 : count)) {
            return false;
        }
        if (is_run) {
            std::fill_n(out.begin(), count, static_cast<std::uint8_t>(source.take(1).front()));
        } else {
            std::ranges::copy(source.take(count), out.begin());
        }
        out = out.subspan(count);
    }
    return true;
}

/// The fewest bytes that the rows of a picture take: their heads, and runs of two bytes.
std::size_t least_bytes(std::size_t columns, std::size_t rows) {
    return rows * (kComponents + kComponents * 2 * ((columns + kLongestRun - 1) / kLongestRun));
}

/// 2^(exponent - 136), or 0 for the exponent 0, which means black.
std::array<float, 256> scales() {
    std::array<float, 256> values{};
    for (int exponent = 1; exponent < 256; ++exponent) {
        values[static_cast<std::size_t>(exponent)] = std::ldexp(1.0f, exponent - kExponentOffset);
    }
    return values;
}

}  // namespace

bool is_radiance(std::string_view head) {
    return head.starts_with("#?");
}

std::optional<RawPicture> decode_radiance(std::span<const std::byte> bytes,
                                          const std::string& path) {
    Source source(bytes);
    const auto size = read_header(source);
    if (!size || size->first < kNarrowestPacked || size->first > kWidestPacked ||
        !begins_packed_row(source, size->first)) {
        return std::nullopt;
    }
    const auto [width, height] = *size;
    check_picture_size(path, width, height);
    const std::size_t columns = static_cast<std::size_t>(width);
    if (source.remaining() < least_bytes(columns, static_cast<std::size_t>(height))) {
        refuse_image(path, "the file is too short for its pixels");
    }
    RawPicture picture{width, height, 3, true, {}};
    picture.values.reserve(3 * columns * static_cast<std::size_t>(height));
    const std::array<float, 256> scale_of = scales();
    std::vector<std::uint8_t> row(kComponents * columns);
    for (int y = 0; y < height; ++y) {
        bool is_good = begins_packed_row(source, width);
        if (is_good) {
            (void)source.take(kComponents);
        }
        for (std::size_t c = 0; is_good && c < kComponents; ++c) {
            is_good = unpack(source, std::span(row).subspan(c * columns, columns));
        }
        if (!is_good) {
            refuse_image(path, fmt::format("row {} is damaged", y));
        }
        for (std::size_t x = 0; x < columns; ++x) {
            const float scale = scale_of[row[3 * columns + x]];
            for (std::size_t c = 0; c < 3; ++c) {
                picture.values.push_back(static_cast<float>(row[c * columns + x]) * scale);
            }
        }
    }
    return picture;
}

}  // namespace carom::render
