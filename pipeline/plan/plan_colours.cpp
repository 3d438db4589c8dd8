#include "pipeline/plan/plan_colours.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <variant>

#include <fmt/core.h>

namespace carom::pipeline {

namespace {

// The appearance depends on CSS classes, so that one drawing works on light and dark pages. `ink`
// is text, `faint` is secondary text, `casing` is the outline of paths and balls on the cloth.
constexpr const char* kShared = R"(
text{font-family:"DejaVu Sans",Verdana,sans-serif;font-size:2.6px}
.title{font-size:4.6px;font-weight:bold}
.head{font-size:2.8px;font-weight:bold}
.small{font-size:2.2px}
.number{font-size:2.1px;font-weight:bold;text-anchor:middle}
.middle{text-anchor:middle}
.end{text-anchor:end}
.path,.casing,.stripe{fill:none;stroke-linejoin:round}
.path{stroke-width:.7}
.casing{stroke-width:1.05}
.stripe{stroke-width:.22;stroke:#fff}
.sliding{stroke-dasharray:1.9 1.1}
.airborne{stroke-dasharray:.05 1.25;stroke-linecap:round}
.airborne.path{stroke-width:.85}
.airborne.casing{stroke-width:1.2}
.moving{stroke-width:.3}
.path.curve{stroke-width:.5}
.casing.curve{stroke-width:.72}
.stripe.curve{stroke-width:.16}
.grid{stroke-width:.1;stroke-opacity:.45;fill:none}
.kinetic{stroke-width:.4;fill:none}
.total{stroke-width:.3;stroke-dasharray:1.2 .8;fill:none}
.area{fill-opacity:.1}
.ball{stroke-width:.18}
.ring{stroke-width:.62}
.ghost{fill-opacity:.38;stroke-width:.14}
.fine{stroke-width:.15;fill:none}
.aim{stroke-width:.2;stroke-dasharray:.8 .8;fill:none}
.prop{stroke-width:.14;fill-opacity:.8}
.overhead{stroke-width:.14;stroke-dasharray:.6 .6;fill-opacity:.08}
.cone{stroke-width:.16;fill-opacity:.07;stroke-opacity:.75}
.way{stroke-width:.35;fill:none}
.tick{stroke-width:.14;fill:none}
.long-tick,.view{stroke-width:.3;fill:none}
.bar{fill-opacity:.22;stroke-width:.25}
)";

struct Palette {
    const char* paper;
    const char* ink;
    const char* faint;
    const char* cloth;
    const char* cushion;
    const char* rail;
    const char* hole;
    const char* casing;
    const char* badge;
    const char* badge_ink;
    const char* stick;
};

constexpr Palette kLight{"#ffffff", "#1c1f22", "#70777d", "#eaf2ec", "#cfe0d4", "#efe6da",
                         "#5d6166", "#3b4046", "#1c1f22", "#ffffff", "#d9b47c"};
constexpr Palette kDark{"#15181b", "#e9ecee", "#9aa3ab", "#22372d", "#2f4d3e", "#3a2f26",
                        "#08090a", "#c9d1d6", "#f2f4f5", "#15181b", "#b98e55"};

std::string rules(const Palette& p) {
    const auto rule = [](const char* selector, const char* property, const char* value) {
        return std::string(selector) + "{" + property + ":" + value + "}\n";
    };
    return rule(".paper", "fill", p.paper) + rule("text,.ink", "fill", p.ink) +
           rule(".faint,text.faint", "fill", p.faint) + rule(".line,.kinetic", "stroke", p.ink) +
           rule(".area", "fill", p.ink) + rule(".fine,.aim,.grid,.total", "stroke", p.faint) +
           rule(".cloth", "fill", p.cloth) + rule(".cushion", "fill", p.cushion) +
           rule(".rail", "fill", p.rail) + rule(".hole", "fill", p.hole) +
           rule(".sight", "fill", p.faint) + rule(".casing", "stroke", p.casing) +
           rule(".ball,.ghost,.ring-edge,.prop,.overhead", "stroke", p.casing) +
           rule(".badge", "fill", p.badge) + rule("text.number", "fill", p.badge_ink) +
           rule(".halo", "stroke", p.paper) + rule(".stick", "fill", p.stick);
}

/// IEC 61966-2-1, the sRGB encoding.
int encoded(double linear) {
    const double c = std::clamp(linear, 0.0, 1.0);
    const double value = c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
    return static_cast<int>(std::lround(255 * value));
}

std::string hex(const Vec3& linear) {
    return fmt::format("#{:02x}{:02x}{:02x}", encoded(linear.x), encoded(linear.y),
                       encoded(linear.z));
}

constexpr double kUnknownGrey = 0.33;  // of pictures and patterns

Vec3 plan_colour(const render::ColourSource& source) {
    if (const auto* plain = std::get_if<Vec3>(&source)) {
        return *plain;
    }
    if (const auto* ball = std::get_if<render::BallTexture>(&source)) {
        return ball->colour;
    }
    if (const auto* mix = std::get_if<std::shared_ptr<const render::MixTexture>>(&source)) {
        const double by = (*mix)->by.constant_or(0.5);
        return plan_colour((*mix)->a) * (1 - by) + plan_colour((*mix)->b) * by;
    }
    return Vec3(kUnknownGrey);
}

/// The first ball in a texture, for its stripe and number; nullptr if it has none.
const render::BallTexture* find_ball(const render::ColourSource& source) {
    if (const auto* mix = std::get_if<std::shared_ptr<const render::MixTexture>>(&source)) {
        const render::BallTexture* ball = find_ball((*mix)->a);
        return ball != nullptr ? ball : find_ball((*mix)->b);
    }
    return std::get_if<render::BallTexture>(&source);
}

ObjectPaint paint_of(const render::ColourSource& source) {
    ObjectPaint paint;
    if (const render::BallTexture* ball = find_ball(source)) {
        paint.is_striped = ball->striped;
        paint.number = ball->number;
    }
    paint.colour = hex(plan_colour(source));
    return paint;
}

}  // namespace

std::string plan_style(PlanPage page) {
    std::string style = kShared + rules(page == PlanPage::dark ? kDark : kLight);
    if (page == PlanPage::automatic) {
        style += "@media (prefers-color-scheme:dark){\n" + rules(kDark) + "}\n";
        style += "@media print{\n" + rules(kLight) + "}\n";
    }
    return style;
}

ObjectPaint paint_of(const Shot& shot, const std::string& name) {
    const auto& objects = shot.scene.objects;
    const auto object = std::find_if(objects.begin(), objects.end(),
                                     [&](const auto& o) { return o.track == name; });
    if (object == objects.end()) {
        return {};
    }
    return paint_of_material(shot, object->material);
}

ObjectPaint paint_of_material(const Shot& shot, const std::string& name) {
    const auto& materials = shot.scene.materials;
    const auto material = std::find_if(materials.begin(), materials.end(),
                                       [&](const auto& m) { return m.name == name; });
    if (material == materials.end()) {
        return {};
    }
    return paint_of(material->phong ? material->phong->diffuse : material->surface.base);
}

std::string rig_colour(std::size_t index) {
    // Okabe and Ito, "Color Universal Design", 2008, without black and yellow.
    constexpr std::array<const char*, 6> kColours{"#0072b2", "#d55e00", "#009e73",
                                                  "#cc79a7", "#e69f00", "#56b4e9"};
    return kColours.at(index % kColours.size());
}

}  // namespace carom::pipeline
