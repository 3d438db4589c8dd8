// Text overlays on a finished picture.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace carom::render {

struct PictureText {
    std::vector<std::string> lines;  // UTF-8
    bool at_top = false;
    bool at_right = false;
    double size = 0.045;  // of a line, in picture heights
};

/// Draws white letters with a dark edge over display-encoded RGB (width * height * 3, row by row
/// from the top left). `white` is the value of the letters' white. Text beyond the picture is cut
/// off. Throws Error if the font (DejaVu Sans Mono) is missing.
void draw_text(const PictureText& text, std::span<std::uint16_t> rgb, int width, int height,
               std::uint16_t white = 65535);
void draw_text(const PictureText& text, std::span<std::uint8_t> rgb, int width, int height);

}  // namespace carom::render
