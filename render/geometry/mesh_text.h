// The text of mesh files: lines, words and numbers, and what there is to say about them. Internal
// to this folder.
#pragma once

#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "render/geometry/mesh_file.h"

namespace carom::render {

/// Upper bound for the corners of one face.
inline constexpr std::size_t kMaxCorners = 16'384;

/// What readers throw when a file cannot be used; read_mesh_file catches it.
struct MeshRefusal {
    MeshRemark remark;
};

/// `line`: from 1, or 0 for the file as a whole.
[[noreturn]] void refuse(std::size_t line, std::string sentence);

/// Throws MeshRefusal if a face has too few or too many corners.
void check_corner_count(std::size_t count, std::size_t line);

/// What readers leave out or repair. One warning per kind counts all cases and names the first.
enum class MeshBlemish {
    bad_normal,
    bad_uv,
    uv_count,
    some_corners_without_normal,
    some_corners_without_uv,
    index_zero,
    unknown_statement,
    curved_surface,
    several_pictures,
};

class MeshBlemishes {
  public:
    void add(MeshBlemish blemish, std::size_t first_line, std::size_t count = 1) {
        Cases& cases = cases_[blemish];
        cases.first_line = cases.count == 0 ? first_line : cases.first_line;
        cases.count += count;
    }

    [[nodiscard]] std::vector<MeshRemark> warnings() const;

  private:
    struct Cases {
        std::size_t first_line = 0;
        std::size_t count = 0;
    };

    std::map<MeshBlemish, Cases> cases_;
};

/// What is between words of one line.
[[nodiscard]] constexpr bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\f' || c == '\v';
}

[[nodiscard]] constexpr bool is_line_end(char c) {
    return c == '\n' || c == '\r';
}

/// Where the line after the one that ends at `end` begins: "\n", "\r\n" and "\r" end a line.
[[nodiscard]] std::size_t after_line_end(std::string_view text, std::size_t end);

/// Appends the words of one line.
void add_words(std::string_view line, std::vector<std::string_view>& words);

/// The number that a word is. NaN for the words with which programs write numbers that are none
/// ("nan", "inf", "-1.#IND") and for numbers too large for a double; nothing for any other word.
[[nodiscard]] std::optional<double> number_of(std::string_view word);

/// "'1.5.2' is not a number", with a hint where it is known what was meant.
[[nodiscard]] std::string not_a_number(std::string_view word);

/// A word in quotes as it may be printed: shortened, without control characters.
[[nodiscard]] std::string quoted(std::string_view word);

}  // namespace carom::render
