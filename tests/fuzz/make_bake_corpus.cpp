// make_bake_corpus FOLDER: writes the corpus of fuzz_bake: contents of small bakes, and one
// complete file.
#include <cstdio>
#include <exception>
#include <string>

#include "core/atomic_file.h"
#include "sim/timeline/bake_format.h"

namespace {

using namespace carom;
using namespace carom::sim;

Key key_at(double time) {
    Key key;
    key.time = time;
    key.position = {time, -0.5 * time, 0.03};
    key.velocity_in = key.velocity_out = {1, -0.5, 0};
    key.angular_velocity_in = {17, 35, 0};
    key.angular_velocity_out = {17, 30, 2};
    return key;
}

Bake rolling_bake() {
    Bake bake;
    bake.timeline.end_time = 2;
    bake.timeline.tracks.emplace_back("cue", std::vector<Key>{key_at(0), key_at(1), key_at(2)});
    bake.timeline.tracks.emplace_back("one", std::vector<Key>{key_at(0.5)});
    return bake;
}

Bake eventful_bake() {
    Bake bake;
    bake.timeline.end_time = 1;
    for (int kind = 0; kind <= static_cast<int>(EventKind::removed); ++kind) {
        bake.timeline.events.push_back(
            {static_cast<EventKind>(kind), 0.1 * kind, 0.1 * kind, "cue", "cushion"});
    }
    bake.timeline.energy = {{0, 1, 2}, {0.5, 1, 1}, {1, 0, 1}};
    bake.timeline.lasting_contacts = {{"cue", "cloth", 0.25, 0.5, 1.75, 0.125}};
    bake.timeline.put_backs = {{"cue", 0.75, {1, 0, -0.5}, {0, 0, 0.03}}};
    bake.timeline.warnings = {
        {Subject::event(1), "tip", "the tip is far off centre", Severity::warning},
        {Subject::body("cue"), "", "'cue' is not potted", Severity::warning}};
    return bake;
}

Bake annotated_bake() {
    Bake bake = rolling_bake();
    bake.shot_text = "carom: 1\n";
    bake.assets = {{"/a.obj", {1, 2}}, {"/b.hdr", {3, 4}}};
    return bake;
}

}  // namespace

int main(int count, char** arguments) try {
    if (count != 2) {
        std::fprintf(stderr, "usage: make_bake_corpus FOLDER\n");
        return 2;
    }
    const std::string folder = std::string(arguments[1]) + "/";
    write_file_atomically(folder + "content_empty", encode_content(Bake{}));
    write_file_atomically(folder + "content_tracks", encode_content(rolling_bake()));
    write_file_atomically(folder + "content_events", encode_content(eventful_bake()));
    write_file_atomically(folder + "content_assets", encode_content(annotated_bake()));
    write_file_atomically(folder + "file_empty", encode_bake(Bake{}));
    return 0;
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
}
