#include <algorithm>

#include "pipeline/plan/plan_drawing.h"
#include "pipeline/plan/quantity_text.h"

namespace carom::pipeline {

namespace {

constexpr double kLine = 4.4;  // mm
constexpr double kText = 2.4;  // font size, mm
constexpr double kTime = 16;   // width of the time, mm

}  // namespace

double draw_moment_list(PlanDrawing& plan, double y) {
    double x = kMargin;
    bool is_any = false;
    plan.svg.open("g", {{"id", "moments"}});
    for (const ShotMoment& moment : plan.shot.moments) {
        const double width = kTime + text_width(moment.key_path, kText) + 6;
        if (x > kMargin && x + width > kPageWidth - kMargin) {
            x = kMargin;
            y += kLine;
        }
        const std::string line = svg_number(y + kLine / 2 + 0.95);
        plan.svg.text("text", moment.time ? time_text(*moment.time) : "never",
                      {{"class", "end faint"}, {"x", svg_number(x + kTime - 2)}, {"y", line}});
        plan.svg.text("text", moment.key_path, {{"x", svg_number(x + kTime)}, {"y", line}});
        x += width;
        is_any = true;
    }
    plan.svg.close();
    return is_any ? y + kLine : y;
}

}  // namespace carom::pipeline
