#include "render/geometry/ply_values.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <optional>
#include <utility>

#include <fmt/core.h>

#include "render/geometry/mesh_text.h"

namespace carom::render {
namespace {

constexpr std::size_t kMaxHeaderBytes = 65'536;
constexpr std::size_t kMaxProperties = 256;  // of one element

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

class HeaderReader {
  public:
    /// Whether the line ends the header.
    bool read_line(std::string_view line) {
        ++line_number_;
        std::vector<std::string_view> words;
        add_words(line, words);
        if (words.size() > 2 && words[0] == "comment" && words[1] == "TextureFile") {
            const std::string_view last = words.back();
            header.pictures.emplace_back(words[2].data(), last.data() + last.size());
        }
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
        } else if (words[0] == "end_header") {
            complain("the header names no format");
        } else if (words[0] != "ply" || is_begun_) {
            complain("not a line of a PLY header");
        }
        is_begun_ = true;
        return false;
    }

    [[nodiscard]] std::size_t lines() const { return line_number_; }

    PlyHeader header;

  private:
    [[noreturn]] void complain(const std::string& what) const { refuse(line_number_, what); }

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

    std::size_t line_number_ = 0;
    bool is_begun_ = false;
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

void check_counts(const PlyHeader& header, std::size_t left) {
    for (const PlyElement& element : header.elements) {
        const std::size_t bytes = least_bytes(element, header.format);
        // One more byte is allowed, because the last number of a text needs no blank after it.
        if (bytes == 0 ? element.count > 0 : element.count > (left + 1) / bytes) {
            refuse(0,
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

PlyHeader read_ply_header(std::string_view text) {
    HeaderReader reader;
    const std::string_view head = text.substr(0, kMaxHeaderBytes);
    std::size_t begin = 0;
    std::optional<bool> ends_with_feed;  // whether the first line ends with "\r\n"
    for (bool is_last = false; !is_last;) {
        const std::size_t end = head.find_first_of("\r\n", begin);
        if (end == std::string_view::npos) {
            refuse(0, "the header of the PLY file does not end");
        }
        is_last = reader.read_line(head.substr(begin, end - begin));
        begin = after_line_end(text, end);
        if (!ends_with_feed) {
            ends_with_feed = begin == end + 2;
        } else if (is_last && head[end] == '\r' && !*ends_with_feed) {
            begin = end + 1;  // in a binary file the first value may begin with the byte of "\n"
        }
    }
    reader.header.end = begin;
    reader.header.line = reader.lines() + 1;
    check_counts(reader.header, text.size() - begin);
    return std::move(reader.header);
}

bool PlyValues::skip_blanks() {
    const std::size_t line = line_;
    while (at_ < text_.size()) {
        if (is_line_end(text_[at_])) {
            at_ = after_line_end(text_, at_);
            ++line_;
        } else if (is_blank(text_[at_])) {
            ++at_;
        } else {
            break;
        }
    }
    return line_ != line || at_ == text_.size();
}

void PlyValues::begin_element() {
    const bool is_first = is_first_;
    is_first_ = false;
    if (format_ == PlyFormat::text && !skip_blanks() && !is_first) {
        refuse(line_, "this line or the one before it has too many or too few numbers");
    }
}

double PlyValues::next(PlyType type) {
    return format_ == PlyFormat::text ? next_word() : next_bytes(type);
}

double PlyValues::next_word() {
    skip_blanks();
    std::size_t end = at_;
    while (end < text_.size() && !is_blank(text_[end]) && !is_line_end(text_[end])) {
        ++end;
    }
    if (at_ == end) {
        refuse(0, "the file ends before its last number");
    }
    const std::string_view word = text_.substr(at_, end - at_);
    at_ = end;
    const std::optional<double> value = number_of(word);
    if (!value) {
        refuse(line_, not_a_number(word));
    }
    return *value;
}

double PlyValues::next_bytes(PlyType type) {
    const std::size_t size = size_of(type);
    if (text_.size() - at_ < size) {
        refuse(0, "the file ends before its last number");
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
        refuse(line(), "a list has an impossible length");
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
