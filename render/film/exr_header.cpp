#include "render/film/exr_header.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <string_view>
#include <vector>

#include <fmt/core.h>

namespace carom::render {
namespace {

constexpr std::size_t kMostHeaderBytes = std::size_t{16} << 20;  // manifests can be long
constexpr std::size_t kLongestName = 255;
constexpr int kMostAttributes = 4096;
/// Version 2 of the format, with no flag except long names: one part with scan lines.
constexpr std::uint32_t kVersion = 2;
constexpr std::uint32_t kLongNames = 0x400;
constexpr std::uint32_t kMagic = 20000630;
/// The attributes of a frame, with their lengths where the format defines them; OpenEXR trusts the
/// type and ignores the length in the file.
struct AttributeType {
    std::string_view name;
    std::size_t length = 0;  // 0: any
};
constexpr std::array<AttributeType, 11> kTypes{{{"string"},
                                                {"chlist"},
                                                {"compression", 1},
                                                {"lineOrder", 1},
                                                {"box2i", 16},
                                                {"float", 4},
                                                {"v2f", 8},
                                                {"int", 4},
                                                {"m44f", 64},
                                                {"rational", 8},
                                                {"chromaticities", 32}}};
/// Deflate compresses by less than this factor (RFC 1951: 258 bytes in two bits).
constexpr double kMostPacked = 1100;

/// Reads little-endian values from the front of the file; beyond the loaded part there are none.
class HeaderReader {
  public:
    HeaderReader(std::string_view bytes, std::uintmax_t file_length)
        : rest_(bytes), beyond_(file_length - bytes.size()) {}

    [[nodiscard]] bool is_good() const { return is_good_; }

    std::uint32_t number() {
        if (rest_.size() < 4) {
            is_good_ = false;
            return 0;
        }
        std::uint32_t value = 0;
        for (std::size_t i = 4; i > 0; --i) {
            value = value << 8U | static_cast<unsigned char>(rest_[i - 1]);
        }
        rest_.remove_prefix(4);
        return value;
    }

    std::string_view name() {
        const std::size_t end = rest_.substr(0, kLongestName + 1).find('\0');
        if (end == std::string_view::npos) {
            is_good_ = false;
            return {};
        }
        const std::string_view text = rest_.substr(0, end);
        rest_.remove_prefix(end + 1);
        return text;
    }

    std::string_view bytes(std::uint32_t size) {
        if (size > rest_.size()) {
            is_good_ = false;
            return {};
        }
        const std::string_view taken = rest_.substr(0, size);
        rest_.remove_prefix(size);
        return taken;
    }

    /// Bytes of the file after what was read.
    [[nodiscard]] std::uintmax_t remaining() const { return rest_.size() + beyond_; }

  private:
    std::string_view rest_;
    std::uintmax_t beyond_;
    bool is_good_ = true;
};

/// Width times height of a box2i; 0 if it is not one.
double area_of(std::string_view window) {
    HeaderReader reader(window, window.size());
    const auto edge = [&] {
        return static_cast<double>(static_cast<std::int32_t>(reader.number()));
    };
    const double x0 = edge();
    const double y0 = edge();
    const double x1 = edge();
    const double y1 = edge();
    return reader.is_good() && x1 >= x0 && y1 >= y0 ? (x1 - x0 + 1) * (y1 - y0 + 1) : 0;
}

/// A channel list: a name and 16 bytes for each channel, and an empty name at the end.
bool is_channel_list(std::string_view value) {
    HeaderReader reader(value, value.size());
    while (reader.is_good() && !reader.name().empty()) {
        (void)reader.bytes(16);
    }
    return reader.is_good() && reader.remaining() == 0;
}

bool is_known(std::string_view type, std::string_view value) {
    const auto known = std::find_if(kTypes.begin(), kTypes.end(), [&](const AttributeType& entry) {
        return entry.name == type && (entry.length == 0 || entry.length == value.size());
    });
    return known != kTypes.end() && (type != "chlist" || is_channel_list(value));
}

std::string problem_in(HeaderReader& reader) {
    if (reader.number() != kMagic) {
        return "it is no OpenEXR file";
    }
    if ((reader.number() & ~kLongNames) != kVersion) {
        return "it is an OpenEXR file of another kind";
    }
    double pixels = 0;
    for (int i = 0; i < kMostAttributes; ++i) {
        const std::string_view name = reader.name();
        if (!reader.is_good() || name.empty()) {
            break;
        }
        const std::string_view type = reader.name();
        const std::string_view value = reader.bytes(reader.number());
        if (!is_known(type, value)) {
            return fmt::format("frames have no attribute of the type '{}' and length {}", type,
                               value.size());
        }
        if (name == "compression" && value != std::string_view("\0", 1) && value != "\3") {
            return "frames are packed by 'zip'";
        }
        if (name == "dataWindow") {
            pixels = area_of(value);
        }
    }
    if (!reader.is_good()) {
        return "its header is longer than the file, or than headers are";
    }
    // A pixel has at least one half float.
    if (!(pixels > 0) || 2 * pixels / kMostPacked > static_cast<double>(reader.remaining())) {
        return "the file is too short for its pixels";
    }
    return {};
}

}  // namespace

std::string find_exr_header_problem(const std::string& path) {
    std::ifstream file(path, std::ios::binary | std::ios::ate);
    const std::streamoff length = file ? static_cast<std::streamoff>(file.tellg()) : -1;
    if (length < 0) {
        return "it cannot be opened";
    }
    std::vector<char> head(std::min(static_cast<std::size_t>(length), kMostHeaderBytes));
    file.seekg(0);
    file.read(head.data(), static_cast<std::streamsize>(head.size()));
    if (!file) {
        return "it cannot be read";
    }
    HeaderReader reader({head.data(), head.size()}, static_cast<std::uintmax_t>(length));
    return problem_in(reader);
}

}  // namespace carom::render
