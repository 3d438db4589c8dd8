// The table from above as a small picture in the picture.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pipeline/picture/canvas.h"
#include "pipeline/shot/shot.h"
#include "sim/billiards/layout.h"
#include "sim/timeline/timeline.h"

namespace carom::pipeline {

/// Draws it at any time of the scene. Refers to the timeline.
class SmallPlan {
  public:
    SmallPlan(const Shot& shot, const sim::Timeline& timeline);

    [[nodiscard]] double width_per_height() const { return half_.x / half_.y; }

    /// Draws the table with +x to the right, `height` pixels high, and the balls that are not
    /// potted; with the ways that they have gone up to `scene_time` if `has_paths`.
    void draw(cairo_t* context, const Vec2& corner, double height, double scene_time,
              bool has_paths) const;

  private:
    struct Ball {
        const sim::Track* track = nullptr;
        double radius = 0;
        Vec3 colour{1, 1, 1};  // linear
        bool is_striped = false;
        double gone = 1e300;  // time at which it is potted, s
    };
    void draw_table(cairo_t* context) const;
    void draw_cushions(cairo_t* context) const;
    void draw_path(cairo_t* context, const Ball& ball, double until) const;
    void draw_ball(cairo_t* context, const Ball& ball, const Vec3& position) const;

    const sim::Timeline& timeline_;
    std::optional<sim::billiards::TableLayout> table_;  // with cushions
    Vec2 half_{0.5, 0.5};                               // extent of the drawing from its centre, m
    std::vector<Ball> balls_;
};

}  // namespace carom::pipeline
