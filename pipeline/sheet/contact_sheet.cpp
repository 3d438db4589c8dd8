#include "pipeline/sheet/contact_sheet.h"

#include <algorithm>
#include <cmath>

#include "core/assert.h"
#include "render/film/picture_text.h"

namespace carom::pipeline {

namespace {

using Colour = std::array<std::uint8_t, 3>;

constexpr Colour kPaper{24, 26, 29};

DisplayPicture blank(int width, int height) {
    DisplayPicture picture{width, height, {}};
    for (int i = 0; i < width * height; ++i) {
        picture.rgb.insert(picture.rgb.end(), kPaper.begin(), kPaper.end());
    }
    return picture;
}

void fill(DisplayPicture& picture, int left, int top, int size, const Colour& colour) {
    for (int y = top; y < top + size; ++y) {
        for (int x = left; x < left + size; ++x) {
            std::copy(colour.begin(), colour.end(),
                      picture.rgb.begin() + (std::ptrdiff_t{y} * picture.width + x) * 3);
        }
    }
}

/// `part` lies within `sheet`.
void paste(const DisplayPicture& part, int left, int top, DisplayPicture& sheet) {
    for (int y = 0; y < part.height; ++y) {
        std::copy_n(part.rgb.begin() + std::ptrdiff_t{y} * part.width * 3,
                    std::ptrdiff_t{part.width} * 3,
                    sheet.rgb.begin() + (std::ptrdiff_t{top + y} * sheet.width + left) * 3);
    }
}

/// A strip with one line of text, `line` pixels high.
DisplayPicture strip(const std::string& caption, int width, int line, bool at_right) {
    DisplayPicture picture = blank(width, 2 * line);
    const render::PictureText text{{caption}, true, at_right, 0.5};
    render::draw_text(text, picture.rgb, picture.width, picture.height);
    return picture;
}

struct Layout {
    int columns = 1, rows = 1;
    int cell_width = 0, cell_height = 0;  // size of a picture
    int gap = 0;
    int line = 0;  // height of a line of text

    [[nodiscard]] int head() const { return 3 * line; }
    [[nodiscard]] int foot() const { return 2 * line; }  // space under a picture
    [[nodiscard]] int width() const { return columns * (cell_width + gap) + gap; }
    [[nodiscard]] int height() const { return head() + rows * (cell_height + foot()) + gap; }
};

Layout layout_of(const std::vector<SheetCell>& cells, int columns) {
    const DisplayPicture& first = cells.front().picture;
    Layout layout;
    layout.columns = std::clamp(columns, 1, static_cast<int>(cells.size()));
    layout.rows = (static_cast<int>(cells.size()) + layout.columns - 1) / layout.columns;
    layout.cell_width = first.width;
    layout.cell_height = first.height;
    layout.gap = std::max(4, first.width / 24);
    layout.line = std::clamp(first.width / 20, 9, 32);
    return layout;
}

}  // namespace

DisplayPicture contact_sheet(const std::string& title, const std::string& facts,
                             const std::vector<SheetCell>& cells, int columns) {
    CAROM_ASSERT(!cells.empty());
    const Layout layout = layout_of(cells, columns);
    DisplayPicture sheet = blank(layout.width(), layout.height());
    // Text has a margin of 0.6 lines to the edges of a strip.
    const int inset = static_cast<int>(std::lround(0.6 * layout.line));
    const int row_width = layout.width() - 2 * (layout.gap - inset);
    const int half = row_width / 2;
    paste(strip(title, half, layout.line, false), layout.gap - inset, layout.line / 2, sheet);
    paste(strip(facts, row_width - half, layout.line, true), layout.gap - inset + half,
          layout.line / 2, sheet);
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const SheetCell& cell = cells[i];
        CAROM_ASSERT(cell.picture.width == layout.cell_width &&
                     cell.picture.height == layout.cell_height);
        const int column = static_cast<int>(i) % layout.columns;
        const int row = static_cast<int>(i) / layout.columns;
        const int left = layout.gap + column * (layout.cell_width + layout.gap);
        const int top = layout.head() + row * (layout.cell_height + layout.foot());
        paste(cell.picture, left, top, sheet);
        const int under = top + layout.cell_height;
        const int mark = layout.line * 5 / 8;
        fill(sheet, left, under + layout.line * 7 / 8, mark, cell.colour);
        const int shift = mark + 2;
        paste(strip(cell.line, layout.cell_width - shift, layout.line, false), left + shift, under,
              sheet);
    }
    return sheet;
}

}  // namespace carom::pipeline
