// Pictures side by side with a line under each, as prints of negatives once were looked at.
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
    std::string line;                             // under it
    std::array<std::uint8_t, 3> colour{0, 0, 0};  // of a mark before the line
};

/// The cells (at least one, pictures of one size) in rows of `columns` under a title. What does not
/// fit into its line is cut off. Throws Error if there is no font.
[[nodiscard]] DisplayPicture contact_sheet(const std::string& title, const std::string& facts,
                                           const std::vector<SheetCell>& cells, int columns);

}  // namespace carom::pipeline
