// Small bakes for the tests of the file format.
#pragma once

#include "sim/timeline/bake_file.h"
#include "timeline_helpers.h"

namespace carom::sim::test {

/// A bake with all kinds of content, about three kilobytes.
inline Bake small_bake() {
    Bake bake;
    bake.physics_hash = {0x1234, 0x5678};
    bake.shot_text = "carom: 1\nballs: {cue: {at: [-0.75, 0.12]}}\n";
    bake.assets = {{"/shots/shade.obj", {1, 2}}, {"/shots/studio.hdr", {3, 4}}};
    Timeline& timeline = bake.timeline;
    timeline.start_time = 0;
    timeline.end_time = 2;
    RandomNumbers numbers(99);
    timeline.tracks.emplace_back(
        "cue", std::vector<Key>{random_key(numbers, 0, false), random_key(numbers, 1.25, true),
                                random_key(numbers, 2, false)});
    timeline.tracks.emplace_back("one", std::vector<Key>{random_key(numbers, 0, false)});
    Event strike{EventKind::strike, 0.5, 0.5, "cue", ""};
    strike.vector = {9.2, 0, 0};
    Event impact{EventKind::impact, 1.25,      1.25, "one", "cue",
                 {0.1, 0.2, 0.03},  {1, 0, 0}, 0.3,  0.01};
    Event force{EventKind::force, 1.25, 1.75, "one", ""};
    force.vector = {0, 0, -0.25};
    timeline.events = {strike, impact, force};
    timeline.lasting_contacts = {{"one", "cushion", 0.25, 1, 1.75, 0.125},
                                 {"cue", "one", 0.5, 0.5, 0, 0}};
    timeline.put_backs = {{"cue", 1.5, {0.1, 0.2, -0.03}, {-0.75, 0, 0.03}}};
    timeline.warnings = {{Subject::event(3), "tip", "the tip is far off centre", Severity::warning},
                         {Subject::body("one"), "", "'one' is not potted", Severity::warning},
                         {{}, "", "the simulation gave up on something", Severity::warning}};
    timeline.energy = {{0, 1.5, 0.25}, {0.5, 1.5, 0.25, 0.5}, {2, 1.25, -0.25, 0.75}};
    return bake;
}

}  // namespace carom::sim::test
