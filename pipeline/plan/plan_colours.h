// What the plan is painted with, on a light page and on a dark one.
#pragma once

#include <string>

#include "pipeline/shot/shot.h"

namespace carom::pipeline {

enum class PlanPage {
    automatic,  // as the reader's browser prefers; light in programs that do not know
    light,
    dark,
};

/// The style sheet.
[[nodiscard]] std::string plan_style(PlanPage page);

/// How an object of the scene is painted: "#rrggbb".
struct ObjectPaint {
    std::string colour = "#9a9a9a";
    bool is_striped = false;
    int number = 0;  // 0: none
};

[[nodiscard]] ObjectPaint paint_of(const Shot& shot, const std::string& name);

/// What is made of the material of that name.
[[nodiscard]] ObjectPaint paint_of_material(const Shot& shot, const std::string& name);

/// Told apart on both pages, also by those who see red and green alike.
[[nodiscard]] std::string rig_colour(std::size_t index);

}  // namespace carom::pipeline
