#include <cmath>
#include <numbers>

#include <fmt/core.h>

#include "core/elementary.h"
#include "core/text.h"
#include "sim/billiards/parts.h"

namespace carom::sim::billiards {

namespace {

class ProblemCollector {
  public:
    /// Requires a measure between two limits; NaN is a problem too.
    void require(const std::string& field, const std::string& name, double value, double low,
                 double high) {
        if (!(value >= low && value <= high)) {
            add(field, "the table's " + name + " must be between " + millimetres_text(low) +
                           " and " + millimetres_text(high));
        }
    }
    void add(std::string field, std::string sentence) {
        list_.push_back({{Subject::Kind::table}, std::move(field), std::move(sentence)});
    }
    [[nodiscard]] bool none() const { return list_.empty(); }
    [[nodiscard]] std::vector<Diagnostic> take() { return std::move(list_); }

  private:
    std::vector<Diagnostic> list_;
};

void check_pocket(const PocketMeasures& pocket, const std::string& which,
                  ProblemCollector& problems) {
    const std::string key = "pockets." + which + ".";
    const std::string name = which + " pockets' ";
    problems.require(key + "mouth", name + "mouth", pocket.mouth, 0.02, 1);
    problems.require(key + "throat", name + "throat", pocket.throat, 0.02, 1);
    problems.require(key + "hole_radius", name + "hole radius", pocket.hole_radius, 0.01, 0.5);
    problems.require(key + "shelf", name + "shelf", pocket.shelf, 0, 0.5);
    problems.require(key + "drop", name + "drop", pocket.drop, 0.03, 1);
    problems.require(key + "lip_radius", name + "lip radius", pocket.lip_radius, 0, 0.5);
    constexpr double kDegree = std::numbers::pi / 180;
    if (!(pocket.jaw_angle >= 95 * kDegree && pocket.jaw_angle <= 175 * kDegree)) {
        problems.add(key + "jaw_angle",
                     "the table's " + name + "jaw angle must be between 95 and 175 degrees");
    }
}

void check_measures(const TableMeasures& measures, ProblemCollector& problems) {
    problems.require("length", "length", measures.length, 0.1, 100);
    problems.require("width", "width", measures.width, 0.1, 100);
    if (!measures.has_cushions) {
        return;
    }
    problems.require("cushion_height", "nose height", measures.nose_height, 0.005, 0.5);
    problems.require("cushion_width", "cushion width", measures.cushion_width, 0.01, 0.5);
    problems.require("rail_width", "rail width", measures.rail_width, 0.03, 1);
    problems.require("height", "height", measures.height, 0.2, 2);
    if (problems.none()) {
        problems.require("rail_height", "rail height", measures.rail_height,
                         measures.nose_height + 0.001, 0.6);
    }
    if (!(measures.jaw_restitution >= 0 && measures.jaw_restitution <= 1)) {
        problems.add("pockets.jaw_restitution",
                     "the table's jaw restitution must be between 0 and 1");
    }
    if (measures.corner_pocket) {
        check_pocket(*measures.corner_pocket, "corner", problems);
    }
    if (measures.side_pocket) {
        check_pocket(*measures.side_pocket, "side", problems);
    }
}

// Checks that a jaw runs in the right direction and has room for its rounding.
void check_jaw(const PocketMeasures& pocket, bool is_corner, double cushion_width,
               ProblemCollector& problems) {
    const std::string which = is_corner ? "corner" : "side";
    const Jaw jaw = jaw_of(pocket, is_corner, cushion_width);
    if (!(jaw.length > 0.001) || (is_corner && jaw.turn > std::numbers::pi / 2)) {
        problems.add(
            "pockets." + which + ".throat",
            "the table's " + which +
                " pockets' throat does not fit their mouth and jaw angle: jaws at this angle " +
                (jaw.turn < (is_corner ? std::numbers::pi / 4 : std::numbers::pi / 2) ? "narrow"
                                                                                      : "widen") +
                " towards the hole");
        return;
    }
    if (jaw.lip_tangent_length > 0.95 * jaw.length) {
        problems.add("pockets." + which + ".lip_radius",
                     "the table's " + which + " pockets' lip radius is too large for jaws " +
                         millimetres_text(jaw.length) + " long");
    }
}

// Checks that the hole contains the ends of the jaws and stays inside the wood.
void check_hole(const TableLayout& layout, const PocketLayout& pocket, ProblemCollector& problems) {
    const TableMeasures& measures = layout.measures;
    const std::string which = pocket.is_corner ? "corner" : "side";
    const Jaw jaw = jaw_of(pocket.measures, pocket.is_corner, measures.cushion_width);
    const double closing =
        (pocket.is_corner ? std::numbers::pi / 4 : std::numbers::pi / 2) - jaw.turn;
    const SinCos close = sin_cos(closing);
    const double deep = jaw.length * close.cos;
    const double half = 0.5 * pocket.measures.mouth - jaw.length * close.sin;
    const Vec2 end = pocket.mouth + deep * pocket.axis + half * Vec2(-pocket.axis.y, pocket.axis.x);
    const double distance = (end - pocket.pocket.centre).length();
    if (distance > pocket.pocket.radius + 1e-6) {
        problems.add(
            "pockets." + which + ".hole_radius",
            "the table's " + which +
                " pockets' hole does not reach the ends of their jaws: its radius must be at "
                "least " +
                millimetres_text(distance) + " with this shelf");
    }
    const Vec2 inner_corner(std::copysign(layout.rail.x, pocket.axis.x),
                            std::copysign(layout.rail.y, pocket.axis.y));
    if (pocket.is_corner && (inner_corner - pocket.pocket.centre).length() > pocket.pocket.radius) {
        problems.add("pockets.corner.hole_radius",
                     "the table's corner pockets' hole does not reach the rails' inner corner; "
                     "give it a larger radius or a deeper shelf");
    }
    const Vec2 room =
        layout.outer - Vec2(std::abs(pocket.pocket.centre.x), std::abs(pocket.pocket.centre.y));
    if (std::min(room.x, room.y) < pocket.pocket.radius + 0.02 + 0.16 * measures.rail_width) {
        problems.add("pockets." + which + ".hole_radius",
                     "the table's " + which + " pockets' hole does not fit into rails " +
                         millimetres_text(measures.rail_width) + " wide");
    }
}

void check_cushions(const TableLayout& layout, ProblemCollector& problems) {
    for (const CushionLayout& cushion : layout.cushions) {
        const double from =
            cushion.from + (cushion.jaw_from ? cushion.jaw_from->lip_tangent_length : 0);
        const double to = cushion.to - (cushion.jaw_to ? cushion.jaw_to->lip_tangent_length : 0);
        if (to - from < 0.02) {
            problems.add("pockets",
                         "the table is too small for its pockets: no cushion is left between them");
            return;
        }
    }
}

void check_blocks(const TableLayout& layout, ProblemCollector& problems) {
    for (std::size_t a = 0; a < layout.pockets.size(); ++a) {
        for (std::size_t b = a + 1; b < layout.pockets.size(); ++b) {
            const Pocket& first = layout.pockets[a].pocket;
            const Pocket& second = layout.pockets[b].pocket;
            if ((first.centre - second.centre).length() < first.radius + second.radius + 0.15) {
                problems.add("pockets",
                             "the table is too small for its pockets: their holes are too close");
                return;
            }
        }
    }
}

}  // namespace

std::vector<Diagnostic> find_problems(const TableMeasures& measures) {
    ProblemCollector problems;
    check_measures(measures, problems);
    if (!problems.none() || !measures.has_cushions) {
        return problems.take();
    }
    if (measures.corner_pocket) {
        check_jaw(*measures.corner_pocket, true, measures.cushion_width, problems);
    }
    if (measures.side_pocket) {
        check_jaw(*measures.side_pocket, false, measures.cushion_width, problems);
    }
    if (!problems.none()) {
        return problems.take();
    }
    // With this ball radius, drawn nose and edge of the playing field coincide.
    const TableLayout layout = make_layout(measures, measures.nose_height);
    for (const PocketLayout& pocket : layout.pockets) {
        if (pocket.axis.x >= 0 && pocket.axis.y > 0) {
            check_hole(layout, pocket, problems);
        }
    }
    check_cushions(layout, problems);
    if (problems.none()) {
        check_blocks(layout, problems);
    }
    return problems.take();
}

}  // namespace carom::sim::billiards
