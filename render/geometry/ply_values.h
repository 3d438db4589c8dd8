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
    std::vector<std::string> pictures;  // named by comments
    std::size_t end = 0;                // where the values begin
    std::size_t line = 1;               // its line
};

/// Throws MeshRefusal with the line. Every element count is checked against the remaining text.
[[nodiscard]] PlyHeader read_ply_header(std::string_view text);

/// Reads numbers one after another; throws MeshRefusal at the end of the text and where no number
/// is found.
class PlyValues {
  public:
    PlyValues(std::string_view text, const PlyHeader& header)
        : text_(text), format_(header.format), at_(header.end), line_(header.line) {}

    /// Must be called before the first value of every element. In a text it begins a line of its
    /// own; else a line before it has too many or too few numbers.
    void begin_element();

    /// NaN for a word that means one (number_of in mesh_text.h).
    [[nodiscard]] double next(PlyType type);

    /// The length of a list; throws if it is negative, not a whole number, or more than what
    /// remains.
    [[nodiscard]] std::size_t next_count(PlyType type);

    void skip(const PlyProperty& property);

    /// Of the last value, for messages; 0 in a binary file.
    [[nodiscard]] std::size_t line() const { return format_ == PlyFormat::text ? line_ : 0; }

  private:
    double next_word();
    double next_bytes(PlyType type);
    bool skip_blanks();  // whether they contained the end of a line

    std::string_view text_;
    PlyFormat format_;
    std::size_t at_;
    std::size_t line_;
    bool is_first_ = true;
};

}  // namespace carom::render
