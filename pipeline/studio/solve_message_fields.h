// The fields of the messages about strikes that are sought or judged, in the order in which they
// are written.
#pragma once

#include "core/fields.h"
#include "pipeline/studio/binary_message_fields.h"
#include "pipeline/studio/solve_messages.h"

namespace carom::studio {

constexpr auto fields_of(Describes<SolveShot>) {
    return fields<SolveShot>(field("q", &SolveShot::q), field("v", &SolveShot::v),
                             field("event", &SolveShot::event), field("struck", &SolveShot::struck),
                             field("ball", &SolveShot::ball), field("pocket", &SolveShot::pocket),
                             field("rest", &SolveShot::rest), field("within", &SolveShot::within),
                             field("seconds", &SolveShot::seconds));
}

constexpr auto fields_of(Describes<Judge>) {
    return fields<Judge>(field("q", &Judge::q), field("v", &Judge::v),
                         field("event", &Judge::event), field("wants_map", &Judge::wants_map),
                         field("directions", &Judge::directions));
}

constexpr auto fields_of(Describes<Unsolve>) {
    return fields<Unsolve>();
}

constexpr auto fields_of(Describes<ShotSolution>) {
    return fields<ShotSolution>(
        field("route", &ShotSolution::route), field("pocket", &ShotSolution::pocket),
        field("is_solved", &ShotSolution::is_solved), field("miss", &ShotSolution::miss),
        field("chance", &ShotSolution::chance), field("chance_error", &ShotSolution::chance_error),
        field("window", &ShotSolution::window), field("direction", &ShotSolution::direction),
        field("speed", &ShotSolution::speed), field("is_ball_speed", &ShotSolution::is_ball_speed),
        field("elevation", &ShotSolution::elevation), field("tip", &ShotSolution::tip),
        field("rest", &ShotSolution::rest));
}

constexpr auto fields_of(Describes<SolutionsHead>) {
    return fields<SolutionsHead>(
        field("q", &SolutionsHead::q), field("v", &SolutionsHead::v),
        field("complete", &SolutionsHead::complete), field("message", &SolutionsHead::message),
        field("time", &SolutionsHead::time), field("solve_item", &SolutionsHead::solve_item),
        field("trials", &SolutionsHead::trials),
        field("milliseconds", &SolutionsHead::milliseconds),
        field("solutions", &SolutionsHead::solutions), field("tracks", &SolutionsHead::tracks));
}

constexpr auto fields_of(Describes<Pot>) {
    return fields<Pot>(field("ball", &Pot::ball), field("pocket", &Pot::pocket));
}

constexpr auto fields_of(Describes<Judged>) {
    return fields<Judged>(field("q", &Judged::q), field("v", &Judged::v),
                          field("event", &Judged::event), field("pots", &Judged::pots),
                          field("window", &Judged::window), field("direction", &Judged::direction),
                          field("chance", &Judged::chance),
                          field("chance_error", &Judged::chance_error));
}

constexpr auto fields_of(Describes<StrikeMap>) {
    return fields<StrikeMap>(
        field("q", &StrikeMap::q), field("v", &StrikeMap::v), field("event", &StrikeMap::event),
        field("pots", &StrikeMap::pots), field("directions", &StrikeMap::directions),
        field("speeds", &StrikeMap::speeds), field("columns", &StrikeMap::columns),
        field("rows", &StrikeMap::rows), field("cells", &StrikeMap::cells));
}

}  // namespace carom::studio
