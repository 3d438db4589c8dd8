// Rendering of text from a font's outlines.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

namespace carom::render {

/// The texels that a text covers, half-open, relative to the pen's start on the baseline, y
/// downwards; with one more texel to the right and below than there is ink.
struct LetterBox {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    [[nodiscard]] int width() const { return x1 - x0; }
    [[nodiscard]] int height() const { return y1 - y0; }
};

/// DejaVu Sans Bold by FreeType directly: OpenImageIO's render_text gives the same texels and takes
/// fifty times as long for letters of this size. For one thread at a time.
class Letters {
  public:
    /// Throws Error if the font is not installed.
    Letters();
    ~Letters();
    Letters(const Letters&) = delete;
    Letters& operator=(const Letters&) = delete;

    /// `text` is ASCII, `size` in texels.
    [[nodiscard]] LetterBox box(const std::string& text, int size);

    /// Draws coverage, 255 for ink, from (x, y) on into a square of `side` texels; parts outside
    /// are cut off.
    void draw(const std::string& text, int size, int x, int y, std::span<std::uint8_t> texels,
              int side);

  private:
    struct Font;
    std::unique_ptr<Font> font_;
};

}  // namespace carom::render
