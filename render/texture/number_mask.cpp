#include "render/texture/number_mask.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "core/error.h"
#include "render/letters/letters.h"

namespace carom::render {
namespace {

constexpr int kTrialFontSize = 256;  // pixels, for measuring
constexpr double kFarCorner = 0.70;  // the digits' farthest corners, in radii of the disc
constexpr double kTallest = 1.02;    // the digits' largest height, in radii of the disc
constexpr double kBarHeight = 0.13;  // of the underline, relative to the digits' height
constexpr double kBarGap = 0.12;     // between digits and underline

bool needs_underline(int number) {
    // Whether the number can be read upside down as another one: it consists of 0, 6, 8, 9 and has
    // a 6 or 9.
    bool has_turning = false;
    for (int rest = number; rest > 0; rest /= 10) {
        const int digit = rest % 10;
        if (digit == 6 || digit == 9) {
            has_turning = true;
        } else if (digit != 0 && digit != 8) {
            return false;
        }
    }
    return has_turning;
}

/// The largest font size at which the digits with their underline stay in the disc.
int fitted_font_size(const std::string& text, bool underlined, Letters& letters) {
    const LetterBox box = letters.box(text, kTrialFontSize);
    const double extra = underlined ? 1.0 + kBarHeight + kBarGap : 1.0;
    const double height = box.height() * extra;
    const double half_diagonal = 0.5 * std::sqrt(height * height + 1.0 * box.width() * box.width());
    const double radius = 0.5 * kNumberMaskSize;
    const double scale = std::min(kFarCorner * radius / half_diagonal, kTallest * radius / height);
    return static_cast<int>(kTrialFontSize * scale);
}

}  // namespace

std::shared_ptr<const CoverageMask> draw_number(int number) {
    CAROM_ASSERT(number >= 0 && number <= 999);
    Letters letters(kBallFont);
    const std::string text = fmt::format("{}", number);
    const bool underlined = needs_underline(number);
    const int size = fitted_font_size(text, underlined, letters);
    const LetterBox box = letters.box(text, size);
    const int gap = static_cast<int>(box.height() * kBarGap);
    const int bar = static_cast<int>(box.height() * kBarHeight);
    const int total_height = box.height() + (underlined ? gap + bar : 0);

    const int left = (kNumberMaskSize - box.width()) / 2;
    const int top = (kNumberMaskSize - total_height) / 2;
    std::vector<std::uint8_t> texels(static_cast<std::size_t>(kNumberMaskSize) * kNumberMaskSize);
    letters.draw(text, size, left - box.x0, top - box.y0, texels, kNumberMaskSize);
    if (underlined) {
        const int y = top + box.height() + gap;
        for (int row = y; row < y + bar; ++row) {
            std::fill_n(texels.begin() + std::ptrdiff_t{row} * kNumberMaskSize + left, box.width(),
                        std::uint8_t{255});
        }
    }
    return std::make_shared<const CoverageMask>(kNumberMaskSize, kNumberMaskSize, texels,
                                                Wrap::clamp);
}

}  // namespace carom::render
