#include "render/geometry/ply_values.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <optional>
#include <utility>

#include <fmt/core.h>

#include "core/error.h"

namespace carom::render {
namespace {

constexpr std::size_t kMaxHeaderBytes = 65'536;
constexpr std::size_t kMaxProperties = 256;  // of one element

[[noreturn]] void refuse(const std::string& path, const std::string& what) {
    throw Error("'" + path + "': " + what);
}

std::optional<PlyType> type_of(std::string_view word) {
    static constexpr std::pair<std::string_view, PlyType> kNames[] = {
        {"char", PlyType::int8},       {"uchar", PlyType::uint8},    {"short", PlyType::int16},
        {"ushort", PlyType::uint16},   {"int", PlyType::int32},      {"uint", PlyType::uint32},
        {"float", PlyType::float32},   {"double", PlyType::float64}, {"int8", PlyType::int8},
        {"uint8", PlyType::uint8},     {"int16", PlyType::int16},    {"uint16", PlyType::uint16},
        {"int32", PlyType::int32},     {"uint32", PlyType::uint32},  {"float32", PlyType::float32},
        {"float64", PlyType::float64},
    };
    for (const auto& [name, type] : kNames) {
        if (name == word) {
            return type;
        }
    }
    return std::nullopt;
}

std::vector<std::string_view> words_of(std::string_view line) {
    std::vector<std::string_view> words;
    std::size_t at = 0;
    while ((at = line.find_first_not_of(" \t\r", at)) != std::string_view::npos) {
        const std::size_t end = std::min(line.find_first_of(" \t\r", at), line.size());
        words.push_back(line.substr(at, end - at));
        at = end;
    }
    return words;
}

class HeaderReader {
  public:
    explicit HeaderReader(const std::string& path) : path_(path) {}

    /// Whether the line ends the header.
    bool read_line(std::string_view line) {
        ++line_number_;
        const std::vector<std::string_view> words = words_of(line);
        if (words.empty() || words[0] == "comment" || words[0] == "obj_info") {
            return false;
        }
        if (words[0] == "format" && words.size() >= 2) {
            read_format(words[1]);
        } else if (words[0] == "element" && words.size() == 3) {
            read_element(words);
        } else if (words[0] == "property" && !header.elements.empty()) {
            read_property(words);
        } else if (words[0] == "end_header" && has_format_) {
            return true;
        } else if (line_number_ != 1 || words[0] != "ply") {
            complain("not a line of a PLY header");
        }
        return false;
    }

    PlyHeader header;

  private:
    [[noreturn]] void complain(const std::string& what) const {
        refuse(path_, fmt::format("line {}: {}", line_number_, what));
    }

    void read_format(std::string_view word) {
        has_format_ = true;
        if (word == "ascii") {
            header.format = PlyFormat::text;
        } else if (word == "binary_little_endian") {
            header.format = PlyFormat::little_endian;
        } else if (word == "binary_big_endian") {
            header.format = PlyFormat::big_endian;
        } else {
            complain("an unknown format");
        }
    }

    void read_element(const std::vector<std::string_view>& words) {
        PlyElement element;
        element.name = words[1];
        const char* end = words[2].data() + words[2].size();
        const auto [stop, error] = std::from_chars(words[2].data(), end, element.count);
        if (error != std::errc() || stop != end) {
            complain("an element needs a count");
        }
        header.elements.push_back(std::move(element));
    }

    void read_property(const std::vector<std::string_view>& words) {
        PlyProperty property;
        property.is_list = words.size() == 5 && words[1] == "list";
        if (words.size() != (property.is_list ? 5u : 3u)) {
            complain("a property needs a type and a name");
        }
        const auto type = type_of(words[words.size() - 2]);
        const auto count_type = property.is_list ? type_of(words[2]) : PlyType::uint8;
        if (!type || !count_type || *count_type == PlyType::float32 ||
            *count_type == PlyType::float64) {
            complain("a property of an unknown type");
        }
        property.type = *type;
        property.count_type = *count_type;
        property.name = words.back();
        auto& properties = header.elements.back().properties;
        properties.push_back(std::move(property));
        if (properties.size() > kMaxProperties) {
            complain(fmt::format("more than {} properties", kMaxProperties));
        }
    }

    const std::string& path_;
    int line_number_ = 0;
    bool has_format_ = false;
};

/// A lower bound on the bytes of one element: in text a digit and a blank for each number.
std::size_t least_bytes(const PlyElement& element, PlyFormat format) {
    std::size_t bytes = 0;
    for (const PlyProperty& property : element.properties) {
        const PlyType type = property.is_list ? property.count_type : property.type;
        bytes += format == PlyFormat::text ? 2 : size_of(type);
    }
    return bytes;
}

void check_counts(const PlyHeader& header, std::size_t left, const std::string& path) {
    for (const PlyElement& element : header.elements) {
        const std::size_t bytes = least_bytes(element, header.format);
        // One more byte is allowed, because the last number of a text needs no blank after it.
        if (bytes == 0 ? element.count > 0 : element.count > (left + 1) / bytes) {
            refuse(path,
                   fmt::format("the header announces {} elements '{}', more than fit into the file",
                               element.count, element.name));
        }
    }
}

}  // namespace

std::size_t size_of(PlyType type) {
    switch (type) {
        case PlyType::int8:
        case PlyType::uint8:
            return 1;
        case PlyType::int16:
        case PlyType::uint16:
            return 2;
        case PlyType::int32:
        case PlyType::uint32:
        case PlyType::float32:
            return 4;
        case PlyType::float64:
            break;
    }
    return 8;
}

PlyHeader read_ply_header(std::string_view text, const std::string& path) {
    HeaderReader reader(path);
    const std::string_view head = text.substr(0, kMaxHeaderBytes);
    std::size_t begin = 0;
    for (;;) {
        const std::size_t end = head.find('\n', begin);
        if (end == std::string_view::npos) {
            refuse(path, "the header of the PLY file does not end");
        }
        const bool is_last = reader.read_line(head.substr(begin, end - begin));
        begin = end + 1;
        if (is_last) {
            break;
        }
    }
    reader.header.end = begin;
    check_counts(reader.header, text.size() - begin, path);
    return std::move(reader.header);
}

double PlyValues::next(PlyType type) {
    return format_ == PlyFormat::text ? next_word() : next_bytes(type);
}

double PlyValues::next_word() {
    at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size());
    const std::size_t end = std::min(text_.find_first_of(" \t\r\n", at_), text_.size());
    if (at_ == end) {
        refuse(path_, "the file ends before its last number");
    }
    std::string_view word = text_.substr(at_, end - at_);
    at_ = end;
    if (word.front() == '+') {
        word.remove_prefix(1);
    }
    double value = 0;
    const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || stop != word.data() + word.size()) {
        std::string what("'");
        what.append(word.substr(0, 40)).append("' is not a number");
        refuse(path_, what);
    }
    return value;
}

double PlyValues::next_bytes(PlyType type) {
    const std::size_t size = size_of(type);
    if (text_.size() - at_ < size) {
        refuse(path_, "the file ends before its last number");
    }
    char bytes[8] = {};
    std::memcpy(bytes, text_.data() + at_, size);
    at_ += size;
    if (format_ == PlyFormat::big_endian) {
        std::reverse(bytes, bytes + size);
    }
    const auto as = [&](auto value) {
        std::memcpy(&value, bytes, sizeof value);
        return static_cast<double>(value);
    };
    switch (type) {
        case PlyType::int8:
            return as(std::int8_t{});
        case PlyType::uint8:
            return as(std::uint8_t{});
        case PlyType::int16:
            return as(std::int16_t{});
        case PlyType::uint16:
            return as(std::uint16_t{});
        case PlyType::int32:
            return as(std::int32_t{});
        case PlyType::uint32:
            return as(std::uint32_t{});
        case PlyType::float32:
            return as(float{});
        case PlyType::float64:
            break;
    }
    return as(double{});
}

std::size_t PlyValues::next_count(PlyType type) {
    const double count = next(type);
    if (!(count >= 0) || count != std::floor(count) ||
        count > static_cast<double>(text_.size() - at_)) {
        refuse(path_, "a list has an impossible length");
    }
    return static_cast<std::size_t>(count);
}

void PlyValues::skip(const PlyProperty& property) {
    const std::size_t count = property.is_list ? next_count(property.count_type) : 1;
    for (std::size_t i = 0; i < count; ++i) {
        static_cast<void>(next(property.type));
    }
}

}  // namespace carom::render
