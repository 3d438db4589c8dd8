#include "render/film/picture_text.h"

#include <algorithm>
#include <cmath>

#include "core/assert.h"
#include "render/letters/letters.h"

namespace carom::render {
namespace {

constexpr double kFontSize = 0.78;  // of a line's height
constexpr double kMargin = 0.6;     // from the picture's edges, in lines
constexpr double kEdge = 0.09;      // width of the dark edge, in lines
constexpr float kEdgeDarkness = 0.8F;

/// Coverage by the letters, [0, 255], over a rectangle of the picture.
struct Mask {
    int left = 0;
    int top = 0;
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> letters;

    [[nodiscard]] float at(int x, int y) const {
        return x < 0 || y < 0 || x >= width || y >= height
                   ? 0.0F
                   : static_cast<float>(letters[static_cast<std::size_t>(y) * width + x]) / 255.0F;
    }
};

Mask draw_letters(const PictureText& text, int width, int height) {
    Letters letters(kMonoFont);
    const double line = std::max(4.0, text.size * height);
    const int font_size = std::max(3, static_cast<int>(std::lround(line * kFontSize)));
    const int margin = static_cast<int>(std::lround(line * kMargin));
    int widest = 0;
    for (const std::string& words : text.lines) {
        widest = std::max(widest, letters.box(words, font_size).x1);
    }
    Mask mask;
    mask.width = widest + 2;
    mask.height = static_cast<int>(std::ceil(line * static_cast<double>(text.lines.size()))) + 2;
    mask.left = text.at_right ? width - margin - mask.width : margin;
    mask.top = text.at_top ? margin : height - margin - mask.height;
    mask.letters.resize(static_cast<std::size_t>(mask.width) * mask.height);
    for (std::size_t i = 0; i < text.lines.size(); ++i) {
        const auto baseline = static_cast<int>(std::lround(line * (static_cast<double>(i) + 0.8)));
        letters.draw(text.lines[i], font_size, 0, baseline, mask.letters, mask.width);
    }
    return mask;
}

/// The letters' coverage dilated by `radius` pixels.
float grown(const Mask& mask, int x, int y, int radius) {
    float most = 0;
    for (int dy = -radius; dy <= radius; ++dy) {
        for (int dx = -radius; dx <= radius; ++dx) {
            if (dx * dx + dy * dy <= radius * radius) {
                most = std::max(most, mask.at(x + dx, y + dy));
            }
        }
    }
    return most;
}

template <class Value>
void draw(const PictureText& text, std::span<Value> rgb, int width, int height, Value white) {
    CAROM_ASSERT(rgb.size() == static_cast<std::size_t>(width) * height * 3);
    if (text.lines.empty()) {
        return;
    }
    const Mask mask = draw_letters(text, width, height);
    const int edge = std::max(1, static_cast<int>(std::lround(kEdge * text.size * height)));
    for (int y = -edge; y < mask.height + edge; ++y) {
        for (int x = -edge; x < mask.width + edge; ++x) {
            const int column = mask.left + x;
            const int row = mask.top + y;
            if (column < 0 || row < 0 || column >= width || row >= height) {
                continue;
            }
            const float letter = mask.at(x, y);
            const float left = (1 - letter) * (1 - kEdgeDarkness * grown(mask, x, y, edge));
            Value* pixel = &rgb[(static_cast<std::size_t>(row) * width + column) * 3];
            for (int c = 0; c < 3; ++c) {
                const float value =
                    static_cast<float>(white) * letter + static_cast<float>(pixel[c]) * left;
                pixel[c] = static_cast<Value>(std::lround(value));
            }
        }
    }
}

}  // namespace

void draw_text(const PictureText& text, std::span<std::uint16_t> rgb, int width, int height,
               std::uint16_t white) {
    draw(text, rgb, width, height, white);
}

void draw_text(const PictureText& text, std::span<std::uint8_t> rgb, int width, int height) {
    draw(text, rgb, width, height, std::uint8_t{255});
}

}  // namespace carom::render
