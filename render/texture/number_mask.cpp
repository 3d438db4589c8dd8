#include "render/texture/number_mask.h"

#include <algorithm>
#include <array>
#include <string>

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

#include "sim/timeline/error.h"

namespace carom::render {
namespace {

constexpr int kTrialFontSize = 256;  // pixels; for measuring
constexpr double kReach = 0.70;      // the figures' far corners, in radii of the disc
constexpr double kTallest = 1.02;    // their height, in radii of the disc
constexpr double kBarHeight = 0.13;  // of the underline, relative to the figures' height
constexpr double kBarGap = 0.12;     // between figures and underline

struct Box {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;  // texels, half-open; y downwards from the baseline
    [[nodiscard]] int width() const { return x1 - x0; }
    [[nodiscard]] int height() const { return y1 - y0; }
};

/// The font as OpenImageIO finds it: by name, else where Debian's package fonts-dejavu-core has it.
std::string usable_font() {
    for (const char* name :
         {"DejaVuSans-Bold", "/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf"}) {
        if (OIIO::ImageBufAlgo::text_size("8", kTrialFontSize, name).defined()) {
            return name;
        }
    }
    throw Error(
        "the font DejaVu Sans Bold, which numbers on balls are drawn with, is not installed "
        "(package fonts-dejavu-core)");
}

Box ink_box(const std::string& text, int font_size, const std::string& font) {
    const OIIO::ROI roi = OIIO::ImageBufAlgo::text_size(text, font_size, font);
    return {roi.xbegin, roi.ybegin, roi.xend, roi.yend};
}

bool needs_underline(int number) {
    // Reads as another number when upside down: made of 0, 6, 8, 9 with a 6 or 9 among them.
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

/// The largest font size whose figures, with their underline, stay in the disc.
int fitted_font_size(const std::string& text, bool underlined, const std::string& font) {
    const Box box = ink_box(text, kTrialFontSize, font);
    const double extra = underlined ? 1.0 + kBarHeight + kBarGap : 1.0;
    const double height = box.height() * extra;
    const double half_diagonal = 0.5 * std::sqrt(height * height + 1.0 * box.width() * box.width());
    const double radius = 0.5 * kNumberMaskSize;
    const double scale = std::min(kReach * radius / half_diagonal, kTallest * radius / height);
    return static_cast<int>(kTrialFontSize * scale);
}

}  // namespace

std::shared_ptr<const CoverageMask> draw_number(int number) {
    CAROM_ASSERT(number >= 0 && number <= 999);
    const std::string font = usable_font();
    const std::string text = std::to_string(number);
    const bool underlined = needs_underline(number);
    const int size = fitted_font_size(text, underlined, font);
    const Box box = ink_box(text, size, font);
    const int gap = static_cast<int>(box.height() * kBarGap);
    const int bar = static_cast<int>(box.height() * kBarHeight);
    const int total_height = box.height() + (underlined ? gap + bar : 0);

    const int left = (kNumberMaskSize - box.width()) / 2;
    const int top = (kNumberMaskSize - total_height) / 2;
    OIIO::ImageBuf buffer(
        OIIO::ImageSpec(kNumberMaskSize, kNumberMaskSize, 1, OIIO::TypeDesc::UINT8));
    OIIO::ImageBufAlgo::zero(buffer);
    const std::array<float, 1> ink{1.0f};
    if (!OIIO::ImageBufAlgo::render_text(buffer, left - box.x0, top - box.y0, text, size, font,
                                         OIIO::cspan<float>(ink.data(), 1))) {
        throw Error("the number " + text + " of a ball cannot be drawn: " + buffer.geterror());
    }
    if (underlined) {
        const int y = top + box.height() + gap;
        OIIO::ImageBufAlgo::fill(buffer, OIIO::cspan<float>(ink.data(), 1),
                                 OIIO::ROI(left, left + box.width(), y, y + bar));
    }

    std::vector<std::uint8_t> texels(static_cast<std::size_t>(kNumberMaskSize) * kNumberMaskSize);
    if (!buffer.get_pixels(buffer.roi(), OIIO::TypeDesc::UINT8, texels.data())) {
        throw Error("the number " + text + " of a ball cannot be drawn: " + buffer.geterror());
    }
    return std::make_shared<const CoverageMask>(kNumberMaskSize, kNumberMaskSize,
                                                std::move(texels));
}

}  // namespace carom::render
