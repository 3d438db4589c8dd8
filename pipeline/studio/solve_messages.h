// Strikes that a page asks for by what they shall do, and what is said of a strike as it is.
// messages.h says how the messages are sent.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/studio/binary_messages.h"

namespace carom::studio {

/// Asks for strikes that pot a ball. The answers are SolutionsHeads: the first one as soon as there
/// is a solution, others while they become better, the last one `complete`. The newest question of
/// a page, of this kind or a Judge, is its only one; texts that change end it.
struct SolveShot {
    static constexpr const char* kName = "solve";
    std::int64_t q = 0;    // number of the question; larger than any before
    std::int64_t v = 0;    // version of the motion that the page shows
    int event = 0;         // the strike that is sought, as an index in ShotState.events; as many as
                           // there are: a new one, as the last event
    std::string struck{};  // its ball
    std::string ball{};    // that shall be potted
    std::string pocket{};  // in this one; empty: in any
    std::optional<std::array<double, 2>> rest{};  // where the struck ball shall end, m
    double within = 0.1;                          // m from there
    double seconds = 10;                          // after which the search ends with what it has
};

/// Asks what a strike pots as it is: how far its direction may turn, and the chance. Answered with
/// Judged, then, if wanted, with StrikeMaps, the later ones finer.
struct Judge {
    static constexpr const char* kName = "judge";
    std::int64_t q = 0;
    std::int64_t v = 0;
    int event = 0;
    bool wants_map = false;
    std::optional<std::array<double, 2>> directions{};  // of the map, from, to, rad; absent: around
                                                        // the strike
};

/// Ends the question of the page.
struct Unsolve {
    static constexpr const char* kName = "unsolve";
};

/// A strike that was found.
struct ShotSolution {
    std::string route{};   // "cue - one, one in corner_left_back"
    std::string pocket{};  // in which the ball falls
    bool is_solved = false;
    double miss = 0;  // m by which the struck ball rests outside of its place
    double chance = 0;
    double chance_error = 0;  // standard error
    double window = 0;        // of directions, rad
    double direction = 0;     // rad
    double speed = 0;
    bool is_ball_speed = false;
    double elevation = 0;  // rad
    std::array<double, 2> tip{};
    std::optional<std::array<double, 2>> rest{};  // of the struck ball; absent: off the table
};

/// Binary, type 6. Payload as that of FanHead. The solutions are the best ones first.
struct SolutionsHead {
    static constexpr const char* kName = "solutions";
    static constexpr std::uint32_t kType = 6;
    static constexpr int kNumbersPerPoint = 4;
    std::int64_t q = 0;
    std::int64_t v = 0;
    bool complete = false;
    std::string message{};    // why there is none, a sentence
    double time = 0;          // of the strike, s
    int solve_item = -1;      // which of the shot's `solve` finds that strike; -1: none
    std::int64_t trials = 0;  // simulations so far
    double milliseconds = 0;  // since the question came
    std::vector<ShotSolution> solutions{};
    std::vector<FanTrack> tracks{};  // of what moves from the strike on; `run`: of that solution
};

/// A ball and the pocket in which a strike pots it.
struct Pot {
    std::string ball{};
    std::string pocket{};
};

/// What a strike does as it is.
struct Judged {
    static constexpr const char* kName = "judged";
    std::int64_t q = 0;
    std::int64_t v = 0;
    int event = 0;
    std::vector<Pot> pots{};         // empty: it pots nothing, and nothing else is known
    std::array<double, 2> window{};  // of directions in which it pots them, rad
    double direction = 0;            // of the strike, rad
    double chance = 0;
    double chance_error = 0;
};

/// What comes of a strike with other directions and speeds.
struct StrikeMap {
    static constexpr const char* kName = "strike_map";
    std::int64_t q = 0;
    std::int64_t v = 0;
    int event = 0;
    std::vector<Pot> pots{};             // what counts as success; a pocket may be empty: any
    std::array<double, 2> directions{};  // from, to, rad
    std::array<double, 2> speeds{};      // from, to, m/s
    int columns = 0;
    int rows = 0;
    /// A letter for each cell, row by row from the lowest speed on: "w" success, "a" something to
    /// be avoided, "n" neither.
    std::string cells{};
};

}  // namespace carom::studio
