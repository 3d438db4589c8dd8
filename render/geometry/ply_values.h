// The header and the values of a PLY file. Internal to this folder.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace carom::render {

enum class PlyFormat { text, little_endian, big_endian };
enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

[[nodiscard]] std::size_t size_of(PlyType type);  // bytes

struct PlyProperty {
    std::string name;
    PlyType type = PlyType::float32;  // for lists: of the elements
    bool is_list = false;
    PlyType count_type = PlyType::uint8;
};

struct PlyElement {
    std::string name;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties;
};

struct PlyHeader {
    PlyFormat format = PlyFormat::text;
    std::vector<PlyElement> elements;
    std::size_t end = 0;  // where the values begin
};

/// Throws Error that names `path` and the line. Every element count is checked against the
/// remaining text.
[[nodiscard]] PlyHeader read_ply_header(std::string_view text, const std::string& path);

/// Reads numbers one after another; throws Error that names `path` at the end of the text and where
/// no number is found.
class PlyValues {
  public:
    PlyValues(std::string_view text, const PlyHeader& header, const std::string& path)
        : text_(text), format_(header.format), at_(header.end), path_(path) {}

    [[nodiscard]] double next(PlyType type);

    /// The length of a list; throws if it is negative, not a whole number, or more than what
    /// remains.
    [[nodiscard]] std::size_t next_count(PlyType type);

    void skip(const PlyProperty& property);

  private:
    double next_word();
    double next_bytes(PlyType type);

    std::string_view text_;
    PlyFormat format_;
    std::size_t at_;
    const std::string& path_;
};

}  // namespace carom::render
