// A contact sheet: small pictures in rows, with a line of text under each.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace carom::pipeline {

/// 8-bit RGB, display-encoded, row by row from the top left.
struct DisplayPicture {
    int width = 0;  // pixels
    int height = 0;
    std::vector<std::uint8_t> rgb;  // width * height * 3
};

struct SheetCell {
    DisplayPicture picture;
    std::string line;                             // caption under the picture
    std::array<std::uint8_t, 3> colour{0, 0, 0};  // colour of a mark before the caption
};

/// Draws the cells (at least one, pictures of equal size) in rows of `columns` under a title. Text
/// that does not fit into its line is cut off. Throws Error if no font is found.
[[nodiscard]] DisplayPicture contact_sheet(const std::string& title, const std::string& facts,
                                           const std::vector<SheetCell>& cells, int columns);

}  // namespace carom::pipeline
