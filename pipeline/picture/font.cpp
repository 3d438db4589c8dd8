#include "pipeline/picture/font.h"

#include <algorithm>
#include <utility>

#include <pango/pangocairo.h>
#include <pango/pangofc-fontmap.h>

#include "core/error.h"

namespace carom::pipeline {
namespace {

constexpr double kEm = 0.8;  // of the height of a line

struct Release {
    void operator()(FcConfig* config) const { FcConfigDestroy(config); }
    void operator()(PangoFontMap* map) const { g_object_unref(map); }
    void operator()(PangoContext* context) const { g_object_unref(context); }
    void operator()(PangoFontDescription* font) const { pango_font_description_free(font); }
    void operator()(cairo_font_options_t* options) const { cairo_font_options_destroy(options); }
};
template <class T>
using Held = std::unique_ptr<T, Release>;

/// Fontconfig's settings with this font alone.
Held<FcConfig> config_of(const std::string& file) {
    Held<FcConfig> config(FcConfigCreate());
    const auto* name = static_cast<const FcChar8*>(static_cast<const void*>(file.c_str()));
    if (FcConfigAppFontAddFile(config.get(), name) != FcTrue ||
        FcConfigGetFonts(config.get(), FcSetApplication)->nfont < 1) {
        throw Error("'" + file + "' cannot be read as a font");
    }
    return config;
}

/// Outlines as the font has them, the same at every position.
void set_plain_rendering(PangoContext* context) {
    const Held<cairo_font_options_t> options(cairo_font_options_create());
    cairo_font_options_set_antialias(options.get(), CAIRO_ANTIALIAS_GRAY);
    cairo_font_options_set_hint_style(options.get(), CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options.get(), CAIRO_HINT_METRICS_OFF);
    pango_cairo_context_set_font_options(context, options.get());
    pango_context_set_round_glyph_positions(context, FALSE);
}

}  // namespace

struct Font::Data {
    Held<FcConfig> config;
    Held<PangoFontMap> map;
    Held<PangoContext> context;
    Held<PangoFontDescription> description;
};

LaidText::LaidText(PangoLayout* layout) : layout_(layout) {}
LaidText::LaidText(LaidText&& other) noexcept : layout_(std::exchange(other.layout_, nullptr)) {}
LaidText& LaidText::operator=(LaidText&& other) noexcept {
    std::swap(layout_, other.layout_);
    return *this;
}
LaidText::~LaidText() {
    if (layout_ != nullptr) {
        g_object_unref(layout_);
    }
}

Vec2 LaidText::size() const {
    int width = 0;
    int height = 0;
    pango_layout_get_size(layout_, &width, &height);
    return Vec2(width, height) / PANGO_SCALE;
}

void LaidText::add_outlines(cairo_t* context, const Vec2& corner) const {
    cairo_move_to(context, corner.x, corner.y);
    pango_cairo_layout_path(context, layout_);
}

Font::Font(const std::string& file) : data_(std::make_unique<Data>()) {
    data_->config = config_of(file);
    data_->map.reset(pango_cairo_font_map_new_for_font_type(CAIRO_FONT_TYPE_FT));
    if (!data_->map) {
        throw Error("Cairo was built without FreeType, so that text cannot be drawn");
    }
    pango_fc_font_map_set_config(PANGO_FC_FONT_MAP(data_->map.get()), data_->config.get());
    data_->context.reset(pango_font_map_create_context(data_->map.get()));
    pango_context_set_language(data_->context.get(), pango_language_from_string("en"));
    pango_context_set_base_dir(data_->context.get(), PANGO_DIRECTION_LTR);
    set_plain_rendering(data_->context.get());
    FcPattern* pattern = FcConfigGetFonts(data_->config.get(), FcSetApplication)->fonts[0];
    data_->description.reset(pango_fc_font_description_from_pattern(pattern, FALSE));
}

Font::~Font() = default;

PangoLayout* Font::new_layout(const std::string& text, double line_height) const {
    PangoLayout* layout = pango_layout_new(data_->context.get());
    pango_font_description_set_absolute_size(data_->description.get(),
                                             kEm * line_height * PANGO_SCALE);
    pango_layout_set_font_description(layout, data_->description.get());
    pango_layout_set_text(layout, text.data(), static_cast<int>(text.size()));
    return layout;
}

LaidText Font::lay_out(const std::string& text, double line_height, TextAlign align) const {
    PangoLayout* layout = new_layout(text, line_height);
    LaidText laid(layout);
    pango_layout_set_alignment(layout, align == TextAlign::left     ? PANGO_ALIGN_LEFT
                                       : align == TextAlign::centre ? PANGO_ALIGN_CENTER
                                                                    : PANGO_ALIGN_RIGHT);
    return laid;
}

std::string Font::wrapped(const std::string& text, double line_height, double width) const {
    PangoLayout* layout = new_layout(text, line_height);
    const LaidText owner(layout);
    pango_layout_set_wrap(layout, PANGO_WRAP_WORD);
    pango_layout_set_width(layout, static_cast<int>(std::max(0.0, width) * PANGO_SCALE));
    std::string result;
    const int count = pango_layout_get_line_count(layout);
    for (int i = 0; i < count; ++i) {
        const PangoLayoutLine* line = pango_layout_get_line_readonly(layout, i);
        const auto start = static_cast<std::size_t>(line->start_index);
        std::string words = text.substr(start, static_cast<std::size_t>(line->length));
        const bool is_broken = i + 1 < count && start + words.size() < text.size() &&
                               text[start + words.size()] != '\n';
        while (is_broken && !words.empty() && words.back() == ' ') {
            words.pop_back();
        }
        result += (i > 0 ? "\n" : "") + words;
    }
    return result;
}

}  // namespace carom::pipeline
