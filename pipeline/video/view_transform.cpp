#include "pipeline/video/view_transform.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <span>
#include <string>

#include "core/assert.h"
#include "core/colour.h"
#include "core/elementary.h"
#include "core/error.h"
#include "pipeline/video/code_value.h"
#include "pipeline/video/dither.h"
#include "pipeline/video/glow.h"
#include "pipeline/video/grain.h"
#include "pipeline/video/tone_curve.h"

namespace carom::pipeline {

namespace {

using Colour = std::array<float, 3>;

// Above this value every view is white; the limit keeps the sums below finite.
constexpr float kBrightest = 1e6F;

float luminance(const Colour& c) {
    return carom::luminance({c[0], c[1], c[2]});
}

/// What happens to light before a view.
struct Development {
    float gain = 1;
    const Grade* grade = nullptr;  // or none

    [[nodiscard]] Colour operator()(const float* rgba) const {
        Colour colour{};
        for (std::size_t i = 0; i < 3; ++i) {
            const float value = rgba[i] * gain;
            colour[i] = value > 0 ? std::min(value, kBrightest) : 0.0F;  // NaN is not > 0
        }
        return grade != nullptr ? (*grade)(colour) : colour;
    }
};

/// Mixes a fraction of the colour's luminance into each channel before the tone curve, and removes
/// most of it afterwards ("channel crosstalk": Lottes 2016, cited in tone_curve.h). Without
/// crosstalk a bright saturated light would end as a pure primary; with it the other channels rise
/// too and the light becomes white, as on photographic film. Greys do not change, and both steps
/// preserve luminance.
class FilmicView {
  public:
    FilmicView() : curve_(filmic_curve(parameters_), parameters_.white) {}

    [[nodiscard]] Colour operator()(Colour colour) const {
        const auto mix = static_cast<float>(parameters_.crosstalk);
        const auto unmix = static_cast<float>(parameters_.separation);
        const float light = luminance(colour);
        for (float& channel : colour) {
            channel = curve_(channel + mix * (light - channel));
        }
        const float shown = luminance(colour);
        for (float& channel : colour) {
            channel = (channel - unmix * shown) / (1 - unmix);
        }
        return colour;
    }

  private:
    FilmicParameters parameters_;
    ToneCurve curve_;
};

/// See tone_curve.h.
class AgxView {
  public:
    AgxView() : curve_(logarithmic_curve(parameters_), white_of(parameters_)) {}

    [[nodiscard]] Colour operator()(Colour colour) const {
        const auto inset = static_cast<float>(parameters_.inset);
        const auto outset = static_cast<float>(parameters_.outset);
        const float light = mean(colour);
        for (float& channel : colour) {
            channel = curve_(channel + inset * (light - channel));
        }
        const float shown = mean(colour);
        for (float& channel : colour) {
            channel = (channel - outset * shown) / (1 - outset);
        }
        return colour;
    }

  private:
    static float mean(const Colour& c) { return (c[0] + c[1] + c[2]) / 3; }

    LogarithmicParameters parameters_;
    ToneCurve curve_;
};

struct PlainView {
    [[nodiscard]] Colour operator()(const Colour& colour) const { return colour; }
};

/// No encoding, for pictures that were computed in display values.
float unencoded(float value) {
    return std::min(value, 1.0F);
}

/// Some rows of a film.
struct Rows {
    std::span<const float> rgba;
    int width = 0;
    int height = 0;
};

template <class View, class Encoding>
void transform(const Rows& rows, const Development& developed, const View& view,
               const Encoding& encode, std::vector<std::uint16_t>& display) {
    const std::size_t pixels = rows.rgba.size() / 4;
    for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
        const Colour colour = view(developed(&rows.rgba[4 * pixel]));
        for (std::size_t i = 0; i < 3; ++i) {
            display[3 * pixel + i] = nearest_code(encode(colour[i]) * 65535.0F);
        }
    }
}

void transform_by(const render::OcioView& ocio, const Rows& rows, const Development& developed,
                  std::vector<std::uint16_t>& display) {
    std::vector<float> rgb;
    rgb.reserve(display.size());
    for (std::size_t i = 0; i < rows.rgba.size(); i += 4) {
        const Colour colour = developed(&rows.rgba[i]);
        rgb.insert(rgb.end(), colour.begin(), colour.end());
    }
    ocio.apply(rgb, rows.width, rows.height);
    for (std::size_t i = 0; i < rgb.size(); ++i) {
        const float signal = rgb[i] > 0 ? std::min(rgb[i], 1.0F) : 0.0F;
        display[i] = nearest_code(signal * 65535.0F);
    }
}

std::string ocio_config() {
    const char* path = std::getenv("OCIO");
    if (path == nullptr || *path == 0) {
        throw Error(
            "'view: ocio' needs the environment variable OCIO to name an OpenColorIO "
            "configuration");
    }
    return path;
}

}  // namespace

DisplayView::DisplayView(const OutputSettings& output) : output_(output) {
    if (!is_neutral(output.grade)) {
        grade_.emplace(output.grade);
    }
    if (output.view == ViewTransform::ocio) {
        ocio_.emplace(ocio_config(), render::OcioNames{output.ocio.display, output.ocio.view,
                                                       output.ocio.colour_space});
    }
}

std::vector<std::uint16_t> DisplayView::to_16(const render::Film& film,
                                              const ViewedFrame& frame) const {
    if (frame.lens.is_seen()) {
        return to_16(with_lens(film, frame.lens), frame.number);
    }
    return output_.glow.is_seen() ? rows_to_16(with_glow(film, output_.glow, output_.exposure), 0,
                                               film.height, frame.number)
                                  : rows_to_16(film, 0, film.height, frame.number);
}

std::vector<std::uint16_t> DisplayView::rows_to_16(const render::Film& glowing, int first, int end,
                                                   std::int64_t frame) const {
    CAROM_ASSERT(0 <= first && first <= end && end <= glowing.height);
    const auto width = static_cast<std::size_t>(glowing.width);
    const std::size_t pixels = width * static_cast<std::size_t>(end - first);
    CAROM_ASSERT(glowing.rgba.size() == 4 * width * static_cast<std::size_t>(glowing.height));
    const Rows rows{
        std::span(glowing.rgba).subspan(4 * width * static_cast<std::size_t>(first), 4 * pixels),
        glowing.width, end - first};
    const Development developed{static_cast<float>(exponential2(output_.exposure)),
                                grade_ ? &*grade_ : nullptr};
    std::vector<std::uint16_t> display(3 * pixels);
    static const ToneCurve encode(srgb_encode, 1.0);
    static const FilmicView filmic;
    static const AgxView agx;
    switch (output_.view) {
        case ViewTransform::srgb:
            transform(rows, developed, PlainView{}, encode, display);
            break;
        case ViewTransform::filmic:
            transform(rows, developed, filmic, encode, display);
            break;
        case ViewTransform::raw:
            transform(rows, developed, PlainView{}, unencoded, display);
            break;
        case ViewTransform::agx:
            transform(rows, developed, agx, encode, display);
            break;
        case ViewTransform::ocio:
            transform_by(*ocio_, rows, developed, display);
            break;
    }
    if (output_.grain > 0) {
        add_grain(display, {frame, glowing.width, glowing.height, first}, output_.grain);
    }
    return display;
}

namespace {

/// `first`: the row of the picture at which `fine` begins.
std::vector<std::uint8_t> dithered(const std::vector<std::uint16_t>& fine, int picture_width,
                                   int first) {
    const auto width = static_cast<std::size_t>(picture_width);
    std::vector<std::uint8_t> display(fine.size());
    for (std::size_t i = 0; i < fine.size(); ++i) {
        const auto x = static_cast<std::uint32_t>(i / 3 % width);
        const auto y =
            static_cast<std::uint32_t>(i / 3 / width) + static_cast<std::uint32_t>(first);
        // 257 sixteen-bit steps are one eight-bit step. All channels use the same threshold, so
        // that greys stay grey.
        const std::uint32_t threshold = dither_threshold(x, y) * 257U >> 16U;
        display[i] = static_cast<std::uint8_t>((fine[i] + threshold) / 257U);
    }
    return display;
}

}  // namespace

std::vector<std::uint8_t> DisplayView::to_8(const render::Film& film,
                                            const ViewedFrame& frame) const {
    return dithered(to_16(film, frame), film.width, 0);
}

std::vector<std::uint8_t> DisplayView::rows_to_8(const render::Film& glowing, int first, int end,
                                                 std::int64_t frame) const {
    return dithered(rows_to_16(glowing, first, end, frame), glowing.width, first);
}

void try_view(const OutputSettings& output) {
    static_cast<void>(DisplayView(output));
}

}  // namespace carom::pipeline
