// Letters from a font's outlines.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

namespace carom::render {

/// Texels that a text covers, half-open, from where its first letter stands on the line, y
/// downwards; one more to the right and below than there is ink.
struct LetterBox {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    [[nodiscard]] int width() const { return x1 - x0; }
    [[nodiscard]] int height() const { return y1 - y0; }
};

/// DejaVu Sans Bold, straight from FreeType: OpenImageIO's render_text gives the same texels and
/// takes fifty times as long for letters of this size. For one thread at a time.
class Letters {
  public:
    /// Throws Error if the font is not installed.
    Letters();
    ~Letters();
    Letters(const Letters&) = delete;
    Letters& operator=(const Letters&) = delete;

    /// `text` is ASCII, `size` in texels.
    [[nodiscard]] LetterBox box(const std::string& text, int size);

    /// Coverage, 255 for ink, from (x, y) on, into a square of `side` texels; what lies outside is
    /// left out.
    void draw(const std::string& text, int size, int x, int y, std::span<std::uint8_t> texels,
              int side);

  private:
    struct Font;
    std::unique_ptr<Font> font_;
};

}  // namespace carom::render
