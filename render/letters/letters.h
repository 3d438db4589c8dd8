// Rendering of text from a font's outlines, through FreeType.
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

/// A font, and what an error says if it is missing.
struct LetterFont {
    const char* file;
    const char* name;
    const char* use;      // "numbers on balls are drawn with"
    const char* package;  // Debian's
};

/// A heavy grotesque, as balls have it.
inline constexpr LetterFont kBallFont{"/usr/share/fonts/opentype/urw-base35/NimbusSans-Bold.otf",
                                      "Nimbus Sans Bold", "numbers on balls are drawn with",
                                      "fonts-urw-base35"};
inline constexpr LetterFont kMonoFont{"/usr/share/fonts/truetype/dejavu/DejaVuSansMono.ttf",
                                      "DejaVu Sans Mono", "overlays are written with",
                                      "fonts-dejavu-core"};

/// OpenImageIO's render_text gives the same texels and takes fifty times as long for large letters.
/// For one thread at a time.
class Letters {
  public:
    /// Throws Error if the font is not installed.
    explicit Letters(const LetterFont& font);
    ~Letters();
    Letters(const Letters&) = delete;
    Letters& operator=(const Letters&) = delete;

    /// `text` is UTF-8, `size` in texels. A letter that the font lacks is drawn as a rectangle.
    [[nodiscard]] LetterBox box(const std::string& text, int size);

    /// Draws coverage, 255 for ink, from (x, y) on into rows of `width` texels; parts outside are
    /// cut off.
    void draw(const std::string& text, int size, int x, int y, std::span<std::uint8_t> texels,
              int width);

  private:
    struct Font;
    std::unique_ptr<Font> font_;
};

}  // namespace carom::render
