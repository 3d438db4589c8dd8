#include "pipeline/study/solve_plot.h"

#include <algorithm>
#include <array>
#include <numbers>
#include <sstream>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "core/text.h"
#include "pipeline/plan/plan_svg.h"
#include "pipeline/solve/outcome_map.h"
#include "pipeline/solve/question.h"
#include "pipeline/study/plot_axes.h"

namespace carom::pipeline::study {

namespace {

using solve::MapCell;
using solve::Solution;

constexpr double kDegrees = 180 / std::numbers::pi;
constexpr double kTop = 28;        // of the first map, mm
constexpr double kHeight = 88;     // of a map
constexpr double kBetween = 26;    // maps: the numbers and the name of an axis, and a heading
constexpr double kMapRight = 146;  // its edges
constexpr double kTableLeft = 158;
constexpr std::size_t kLandings = 200;

/// In the order of a legend.
constexpr std::array kCells{MapCell::wanted, MapCell::misplaced, MapCell::avoided,
                            MapCell::nothing};

/// Empty for `nothing`.
std::string colour_of(MapCell cell) {
    return cell == MapCell::wanted      ? rig_colour(2)
           : cell == MapCell::misplaced ? rig_colour(5)
           : cell == MapCell::avoided   ? rig_colour(1)
                                        : "";
}

const char* meaning_of(MapCell cell) {
    return cell == MapCell::wanted      ? "all that is wanted"
           : cell == MapCell::misplaced ? "all but where balls rest"
           : cell == MapCell::avoided   ? "something that is to be avoided"
                                        : "not what is wanted";
}

bool has_places(const solve::SolveProblem& problem) {
    return std::ranges::any_of(problem.wants, solve::is_of_end);
}

/// The edges of evenly spaced cells around these values, in a unit.
PlotAxis axis_over(const std::vector<double>& values, double unit, double from, double to) {
    const double half = 0.5 * (values[1] - values[0]);
    return {unit * (values.front() - half), unit * (values.back() + half), from, to};
}

double speed_of(const sim::Strike& strike) {
    return strike.ball_speed.value_or(strike.speed.value_or(0));
}

std::string percent_text(double part) {
    return fmt::format("{:.0f} %", 100 * part);
}

/// Where balls shall come to rest.
void draw_places(SvgText& svg, const solve::SolveProblem& problem, const Sheet& sheet) {
    for (const solve::Want& want : problem.wants) {
        if (const auto* rest = std::get_if<solve::RestPlace>(&want)) {
            const Vec2 centre = sheet.at(rest->near);
            svg.open("g");
            svg.text("title", rest->ball + " shall rest here");
            svg.leaf("circle", {{"class", "line"},
                                {"cx", svg_number(centre.x)},
                                {"cy", svg_number(centre.y)},
                                {"r", svg_number(sheet.length(rest->within))},
                                {"fill", "none"},
                                {"stroke-width", "0.35"},
                                {"stroke-dasharray", "1.2 0.8"}});
            svg.close();
        }
    }
}

/// Draws the maps of a page.
class MapPage {
  public:
    MapPage(const Shot& shot, const PartsWork& work)
        : shot_(shot), work_(work), svg_(SvgText::Kind::fragment) {}

    [[nodiscard]] std::string draw(PlanPage page) {
        svg_.text("text", shot_.name,
                  {{"class", "title"}, {"x", svg_number(kMargin)}, {"y", "13"}});
        double y = kTop;
        for (const SolvedStrike& solved : shot_.solved) {
            const sim::Trials trials(solved.question->world);
            draw_map(solved, trials, y);
            draw_landings(solved, trials, y);
            y += kHeight + kBetween;
        }
        return svg_page(svg_.finish(), shot_.name + ": what comes of strikes", page,
                        y - kBetween + 16);
    }

  private:
    void draw_map(const SolvedStrike& solved, const sim::Trials& trials, double top) {
        const double bottom = top + kHeight;
        const Solution& best = solved.result->solutions.front();
        heading(best.route, kMargin, top, kPageWidth - 2 * kMargin);
        const solve::OutcomeMap map =
            solve::outcome_map(trials, solved.question->problem, best.strike,
                               solve::range_around(best.strike, best.window_width()), work_);
        const PlotAxis across = axis_over(map.directions, kDegrees, kPlotLeft, kMapRight);
        const PlotAxis upwards = axis_over(map.speeds, 1, bottom, top);
        svg_.leaf("rect", {{"class", "area"},
                           {"x", svg_number(kPlotLeft)},
                           {"y", svg_number(top)},
                           {"width", svg_number(kMapRight - kPlotLeft)},
                           {"height", svg_number(kHeight)}});
        draw_cells(map, top, bottom);
        draw_x_axis(svg_, across, "direction, deg", bottom, bottom);
        draw_y_axis(svg_, upwards, kPlotLeft, kPlotLeft);
        draw_upright(svg_,
                     best.strike.ball_speed ? "speed of the ball, m/s" : "speed of the stick, m/s",
                     kMargin + 2, 0.5 * (top + bottom));
        draw_found(best, across, upwards);
    }

    /// Cells of the same kind beside each other are one rectangle.
    void draw_cells(const solve::OutcomeMap& map, double top, double bottom) {
        constexpr double kOverlap = 0.02;  // so that rounding leaves no gap
        const auto rows = static_cast<double>(map.speeds.size());
        const double width = (kMapRight - kPlotLeft) / static_cast<double>(map.directions.size());
        svg_.open("g", {{"shape-rendering", "crispEdges"}});
        for (std::size_t row = 0; row < map.speeds.size(); ++row) {
            const double high = bottom - (bottom - top) * static_cast<double>(row + 1) / rows;
            const double low = bottom - (bottom - top) * static_cast<double>(row) / rows;
            for (std::size_t from = 0, to = 0; from < map.directions.size(); from = to) {
                const MapCell cell = map.at(row, from);
                while (to < map.directions.size() && map.at(row, to) == cell) {
                    ++to;
                }
                draw_rectangle(
                    svg_, {kPlotLeft + width * static_cast<double>(from), high},
                    {kPlotLeft + width * static_cast<double>(to) + kOverlap, low + kOverlap},
                    colour_of(cell));
            }
        }
        svg_.close();
    }

    /// The strike that was found, and its window.
    void draw_found(const Solution& best, const PlotAxis& across, const PlotAxis& upwards) {
        const Vec2 at(across.at(kDegrees * best.strike.direction.value_or(0)),
                      upwards.at(speed_of(best.strike)));
        draw_mark(at, 0.5 * (across.to - across.from) * kDegrees * best.window_width() /
                          (across.high - across.low));
    }

    /// A strike, and half the width of its window on the paper.
    void draw_mark(const Vec2& at, double half) {
        if (half > 0) {
            const Vec2 reach(half, 0);
            const Vec2 end(0, 1.2);
            svg_.leaf("path", {{"class", "line"},
                               {"fill", "none"},
                               {"stroke-width", "0.35"},
                               {"d", svg_path({at - reach - end, at - reach + end}, false) + " " +
                                         svg_path({at - reach, at + reach}, false) + " " +
                                         svg_path({at + reach - end, at + reach + end}, false)}});
        }
        svg_.leaf("circle", {{"class", "line"},
                             {"cx", svg_number(at.x)},
                             {"cy", svg_number(at.y)},
                             {"r", "1.2"},
                             {"fill", "#ffffff"},
                             {"stroke-width", "0.45"}});
    }

    void draw_landings(const SolvedStrike& solved, const sim::Trials& trials, double top) {
        const Solution& best = solved.result->solutions.front();
        const solve::SolveProblem& problem = solved.question->problem;
        const PlanSketch sketch =
            plan_sketch(shot_, solve::motion_of(trials, problem, best.strike, work_),
                        {kTableLeft, top}, {kPageWidth - kMargin - kTableLeft, kHeight - 20});
        svg_.raw(sketch.svg);
        const std::vector<solve::Landing> all =
            solve::landings(trials, problem, best.strike, kLandings, work_);
        for (auto cell = kCells.rbegin(); cell != kCells.rend(); ++cell) {
            draw_rests(all, *cell, sketch.sheet);
        }
        draw_places(svg_, problem, sketch.sheet);
        draw_legend(all, problem, best, top + sketch.sheet.size().y + 6);
    }

    void draw_rests(const std::vector<solve::Landing>& all, MapCell cell, const Sheet& sheet) {
        const std::string colour = cell == MapCell::nothing ? "#b4b9bd" : colour_of(cell);
        for (const solve::Landing& each : all) {
            if (each.cell == cell && each.rest) {
                const Vec2 at = sheet.at(*each.rest);
                svg_.leaf("circle", {{"class", "ball"},
                                     {"style", "stroke-width:.1"},
                                     {"cx", svg_number(at.x)},
                                     {"cy", svg_number(at.y)},
                                     {"r", "0.6"},
                                     {"fill", colour}});
            }
        }
    }

    void draw_legend(const std::vector<solve::Landing>& all, const solve::SolveProblem& problem,
                     const Solution& best, double y) {
        const solve::PlayerError& player = problem.player;
        for (const std::string& line :
             {fmt::format("Where '{}' rests in {} strikes with the player's errors:", best.ball,
                          all.size()),
              fmt::format("{} deg of direction, {} of speed, {} ball radii at the tip",
                          decimal_text(kDegrees * player.direction, 3), percent_text(player.speed),
                          decimal_text(player.tip, 3))}) {
            svg_.text("text", line,
                      {{"class", "faint"}, {"x", svg_number(kTableLeft)}, {"y", svg_number(y)}});
            y += 4;
        }
        y += 1;
        for (const MapCell cell : kCells) {
            if (cell == MapCell::misplaced && !has_places(problem)) {
                continue;
            }
            const auto count = std::ranges::count(all, cell, &solve::Landing::cell);
            const double part = static_cast<double>(count) / static_cast<double>(all.size());
            draw_patch(svg_, kTableLeft, y, colour_of(cell),
                       fmt::format("{}: {}", meaning_of(cell), percent_text(part)));
            y += 4.6;
        }
        draw_mark({kTableLeft + 2, y}, best.window_width() > 0 ? 2 : 0);
        const std::string window =
            best.window_width() > 0 ? fmt::format(", which succeeds within {} deg",
                                                  decimal_text(kDegrees * best.window_width(), 2))
                                    : "";
        svg_.text("text", "the strike that was found" + window,
                  {{"x", svg_number(kTableLeft + 6)}, {"y", svg_number(y + 0.9)}});
    }

    void heading(const std::string& text, double x, double top, double width) {
        svg_.text("text", fitted_text(text, 2.8, width),
                  {{"class", "head"}, {"x", svg_number(x)}, {"y", svg_number(top - 3.5)}});
    }

    const Shot& shot_;
    const PartsWork& work_;
    SvgText svg_;
};

constexpr std::size_t kMostColumns = 3;  // of plans
constexpr double kApart = 6;             // mm
constexpr double kTallest = 110;         // of a plan
constexpr double kLine = 3.9;

/// The way in words, in lines that fit below a plan.
std::vector<std::string> lines_of(const std::string& text, double width) {
    std::vector<std::string> lines{""};
    std::istringstream words(text);
    for (std::string word; words >> word;) {
        std::string longer = lines.back();
        longer += (longer.empty() ? "" : " ") + word;
        if (lines.back().empty() || text_width(longer, 2.8) <= width) {
            lines.back() = std::move(longer);
        } else {
            lines.push_back(std::move(word));
        }
    }
    return lines;
}

/// Draws the solutions of a page.
class PlansPage {
  public:
    PlansPage(const Shot& shot, const PartsWork& work)
        : shot_(shot), work_(work), svg_(SvgText::Kind::fragment) {}

    [[nodiscard]] std::string draw(PlanPage page) {
        svg_.text("text", shot_.name,
                  {{"class", "title"}, {"x", svg_number(kMargin)}, {"y", "13"}});
        double y = 20;
        for (const SolvedStrike& solved : shot_.solved) {
            if (shot_.solved.size() > 1) {
                svg_.text("text", fmt::format("events[{}]", solved.event),
                          {{"class", "head"}, {"x", svg_number(kMargin)}, {"y", svg_number(y)}});
                y += 4;
            }
            y = draw_strike(solved, y);
        }
        return svg_page(svg_.finish(), shot_.name + ": ways", page, y);
    }

  private:
    /// Returns the y below.
    double draw_strike(const SolvedStrike& solved, double top) {
        const sim::Trials trials(solved.question->world);
        const std::vector<Solution>& solutions = solved.result->solutions;
        const auto count = static_cast<std::size_t>(  // they are the first ones
            std::ranges::count_if(solutions, &Solution::is_solved));
        std::vector<sim::Timeline> motions(count);
        do_parts(count,
                 [&](std::size_t i) {
                     motions[i] = solve::motion_of(trials, solved.question->problem,
                                                   solutions[i].strike, work_);
                 },
                 {work_.threads, {{}, work_.context.stop}});
        const std::size_t columns = std::min(count, kMostColumns);
        const double width =
            (kPageWidth - 2 * kMargin + kApart) / static_cast<double>(columns) - kApart;
        double row = top;
        double bottom = top;
        for (std::size_t i = 0; i < count; ++i) {
            if (i % columns == 0) {
                row = bottom;
            }
            const double left = kMargin + static_cast<double>(i % columns) * (width + kApart);
            bottom = std::max(bottom, draw_way(solved, i, motions[i], {left, row}, width));
        }
        return bottom + 2;
    }

    double draw_way(const SolvedStrike& solved, std::size_t index, const sim::Timeline& motion,
                    const Vec2& corner, double width) {
        const Solution& way = solved.result->solutions[index];
        const PlanSketch sketch = plan_sketch(shot_, motion, corner, {width, kTallest});
        svg_.raw(sketch.svg);
        draw_places(svg_, solved.question->problem, sketch.sheet);
        double y = corner.y + sketch.sheet.size().y + 3;
        for (const std::string& line :
             lines_of(fmt::format("{}. {}", index + 1, way.route), width)) {
            svg_.text("text", line,
                      {{"class", "head"}, {"x", svg_number(corner.x)}, {"y", svg_number(y)}});
            y += kLine;
        }
        std::string facts = "chance " + percent_text(way.chance);
        if (way.window_width() > 0) {
            facts += fmt::format(", within {} deg", decimal_text(kDegrees * way.window_width(), 2));
        }
        facts += fmt::format(", {} m/s, tip [{}, {}]", decimal_text(speed_of(way.strike), 2),
                             decimal_text(way.strike.tip.x, 2), decimal_text(way.strike.tip.y, 2));
        svg_.text("text", facts,
                  {{"class", "faint"}, {"x", svg_number(corner.x)}, {"y", svg_number(y)}});
        return y + 5;
    }

    const Shot& shot_;
    const PartsWork& work_;
    SvgText svg_;
};

}  // namespace

std::string solve_plans_svg(const Shot& shot, PlanPage page, const PartsWork& work) {
    return PlansPage(shot, work).draw(page);
}

std::string solve_map_svg(const Shot& shot, PlanPage page, const PartsWork& work) {
    return MapPage(shot, work).draw(page);
}

}  // namespace carom::pipeline::study
