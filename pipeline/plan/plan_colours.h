// Colours and style sheets of the plan, for light and dark pages.
#pragma once

#include <string>

#include "pipeline/shot/shot.h"

namespace carom::pipeline {

enum class PlanPage {
    automatic,  // follows the browser's preference; light in programs that have none
    light,
    dark,
};

/// The CSS style sheet.
[[nodiscard]] std::string plan_style(PlanPage page);

/// The paint of an object on the plan; colours are "#rrggbb".
struct ObjectPaint {
    std::string colour = "#9a9a9a";
    bool is_striped = false;
    int number = 0;  // 0: none
};

[[nodiscard]] ObjectPaint paint_of(const Shot& shot, const std::string& name);

/// The paint of objects made of the material of that name.
[[nodiscard]] ObjectPaint paint_of_material(const Shot& shot, const std::string& name);

/// Colours that can be distinguished on both pages, also with red-green colour blindness.
[[nodiscard]] std::string rig_colour(std::size_t index);

}  // namespace carom::pipeline
