#include "render/image_files/radiance_file.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "render/image_files/picture_placement.h"

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

/// What the lines before the pixels say.
struct Header {
    int columns = 0;  // as stored
    int rows = 0;
    Orientation orientation = kUpright;
    std::array<double, 3> scale{1, 1, 1};  // of the stored colours
};

/// Takes one sign, the letter of an axis and a number: "-Y 256".
struct Axis {
    bool is_negative = false;
    char letter = 0;
    int length = 0;
};
std::optional<Axis> take_axis(std::string_view& line) {
    if (line.size() < 4 || (line[0] != '-' && line[0] != '+') ||
        (line[1] != 'X' && line[1] != 'Y') || line[2] != ' ') {
        return std::nullopt;
    }
    Axis axis{line[0] == '-', line[1], 0};
    line.remove_prefix(3);
    const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), axis.length);
    line.remove_prefix(static_cast<std::size_t>(end - line.data()));
    return error == std::errc() ? std::optional(axis) : std::nullopt;
}

/// The orientation of a picture whose rows follow each other along the first axis. Radiance's y
/// goes up, so that -Y begins at the top; -X begins at the right.
Orientation orientation_of(const Axis& first, const Axis& second) {
    if (first.letter == 'Y') {
        return first.is_negative ? (second.is_negative ? 2 : 1) : (second.is_negative ? 3 : 4);
    }
    return first.is_negative ? (second.is_negative ? 6 : 7) : (second.is_negative ? 5 : 8);
}

/// Reads "-Y 256 +X 512" with any order and direction of the axes. False if it is something else.
bool read_axes(std::string_view line, Header& header) {
    while (line.ends_with('\r') || line.ends_with(' ')) {
        line.remove_suffix(1);
    }
    const std::optional<Axis> first = take_axis(line);
    if (!first || !line.starts_with(' ')) {
        return false;
    }
    line.remove_prefix(1);
    const std::optional<Axis> second = take_axis(line);
    if (!second || !line.empty() || second->letter == first->letter) {
        return false;
    }
    header.rows = first->length;
    header.columns = second->length;
    header.orientation = orientation_of(*first, *second);
    return true;
}

/// The text after the "=" of a variable with this name; empty if the line is something else.
std::optional<std::string_view> value_in(std::string_view line, std::string_view name) {
    if (!line.starts_with(name) || !line.substr(name.size()).starts_with('=')) {
        return std::nullopt;
    }
    line.remove_prefix(name.size() + 1);
    while (line.ends_with('\r') || line.ends_with(' ') || line.ends_with('\t')) {
        line.remove_suffix(1);
    }
    while (line.starts_with(' ') || line.starts_with('\t')) {
        line.remove_prefix(1);
    }
    return line;
}

/// Divides the scale of each colour by a number of the text, or all by the only one.
void divide_scale(std::string_view name, std::string_view text, const std::string& path,
                  Header& header) {
    std::vector<double> factors;
    const std::string all(text);
    while (!text.empty()) {
        double factor = 0;
        text.remove_prefix(text.starts_with('+') ? 1 : 0);
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), factor);
        if (error != std::errc() || !(factor > 0) || !std::isfinite(factor)) {
            break;
        }
        factors.push_back(factor);
        text.remove_prefix(static_cast<std::size_t>(end - text.data()));
        text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
    }
    if (!text.empty() || (factors.size() != 3 && (factors.size() != 1 || name == "COLORCORR"))) {
        refuse_image(path, fmt::format("its header has '{}={}' where {} above 0 must be", name, all,
                                       name == "COLORCORR" ? "three numbers" : "a number"));
    }
    for (std::size_t c = 0; c < 3; ++c) {
        header.scale[c] /= factors[factors.size() == 3 ? c : 0];
    }
}

/// Variables of other pictures that this one was made from are indented, and are not read.
Header read_header(Source& source, const std::string& path) {
    Header header;
    for (std::string_view line = source.line(); !line.empty() && line != "\r";
         line = source.line()) {
        if (const auto format = value_in(line, "FORMAT"); format && *format != "32-bit_rle_rgbe") {
            refuse_image(
                path, *format == "32-bit_rle_xyze"
                          ? "its colours are XYZ; 'ra_xyze -r' of Radiance converts them "
                            "to RGB"
                          : fmt::format("its format is '{}' instead of 32-bit_rle_rgbe", *format));
        }
        for (const std::string_view name : {"EXPOSURE", "COLORCORR"}) {
            if (const auto value = value_in(line, name)) {
                divide_scale(name, *value, path, header);
            }
        }
    }
    const std::string_view line = source.line();
    if (!read_axes(line, header)) {
        refuse_image(path, fmt::format("its header ends with '{}' where its size must be, such as "
                                       "'-Y 256 +X 512'",
                                       line.substr(0, 40)));
    }
    check_picture_size(path, header.columns, header.rows);
    return header;
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

/// A row whose components follow each other, each compressed. False if it is damaged.
bool take_packed_row(Source& source, int width, std::span<std::uint8_t> row) {
    if (!begins_packed_row(source, width)) {
        return false;
    }
    (void)source.take(kComponents);
    const auto columns = static_cast<std::size_t>(width);
    std::vector<std::uint8_t> components(row.size());
    for (std::size_t c = 0; c < kComponents; ++c) {
        if (!unpack(source, std::span(components).subspan(c * columns, columns))) {
            return false;
        }
    }
    for (std::size_t i = 0; i < row.size(); ++i) {
        row[i] = components[i % kComponents * columns + i / kComponents];
    }
    return true;
}

/// A row of whole pixels; 1 1 1 n repeats the pixel before n times, several of these in succession
/// n + 256 m + ... times. False if it is damaged.
bool take_plain_row(Source& source, std::span<std::uint8_t> row) {
    constexpr int kMostShift = 24;
    int shift = 0;
    for (std::size_t at = 0; at < row.size();) {
        if (source.remaining() < kComponents) {
            return false;
        }
        const std::string_view pixel = source.take(kComponents);
        if (pixel.starts_with("\1\1\1")) {
            const std::size_t count = static_cast<std::size_t>(static_cast<std::uint8_t>(pixel[3]))
                                      << static_cast<unsigned>(shift);
            if (at == 0 || count > (row.size() - at) / kComponents) {
                return false;
            }
            for (std::size_t i = 0; i < count * kComponents; ++i, ++at) {
                row[at] = row[at - kComponents];
            }
            shift = std::min(shift + 8, kMostShift);
        } else {
            std::ranges::copy(pixel, row.begin() + static_cast<std::ptrdiff_t>(at));
            at += kComponents;
            shift = 0;
        }
    }
    return true;
}

/// The fewest bytes that the rows of a compressed picture take: their heads, and runs of two bytes.
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

PictureSize radiance_size(std::span<const std::byte> bytes, const std::string& path) {
    Source source(bytes);
    const Header header = read_header(source, path);
    return turned(PictureSize{header.columns, header.rows}, header.orientation);
}

RawPicture decode_radiance(std::span<const std::byte> bytes, const std::string& path) {
    Source source(bytes);
    const Header header = read_header(source, path);
    const auto columns = static_cast<std::size_t>(header.columns);
    const bool is_packed = header.columns >= kNarrowestPacked && header.columns <= kWidestPacked &&
                           begins_packed_row(source, header.columns);
    if (is_packed &&
        source.remaining() < least_bytes(columns, static_cast<std::size_t>(header.rows))) {
        refuse_image(path, "the file is too short for its pixels");
    }
    RawPicture picture{header.columns, header.rows, 3, true, {}};
    std::vector<float> values;
    values.reserve(is_packed ? 3 * columns * static_cast<std::size_t>(header.rows) : 0);
    const std::array<float, 256> scale_of = scales();
    const bool is_scaled = header.scale != std::array<double, 3>{1, 1, 1};
    std::vector<std::uint8_t> row(kComponents * columns);
    for (int y = 0; y < header.rows; ++y) {
        if (!(is_packed ? take_packed_row(source, header.columns, row)
                        : take_plain_row(source, row))) {
            refuse_image(path, fmt::format("row {} is damaged", y));
        }
        for (std::size_t i = 0; i < row.size(); i += kComponents) {
            const float scale = scale_of[row[i + 3]];
            for (std::size_t c = 0; c < 3; ++c) {
                const float value = static_cast<float>(row[i + c]) * scale;
                values.push_back(is_scaled ? static_cast<float>(value * header.scale[c]) : value);
            }
        }
    }
    picture.values = std::move(values);
    return turned(std::move(picture), header.orientation);
}

}  // namespace carom::render
