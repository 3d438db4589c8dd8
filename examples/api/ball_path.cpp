// ball_path SHOT [BALL]: prints the position of a ball of the shot, ten times per second.
#include <cstdio>
#include <string>

#include <carom/film.h>

namespace {

// Prints the problems of the shot. Returns whether it can be simulated.
bool report(const carom::pipeline::LoadResult& loaded) {
    for (const carom::pipeline::Problem& problem : loaded.problems) {
        std::fputs(format(problem).c_str(), stderr);
    }
    return loaded.shot.has_value();
}

void print_path(const carom::sim::Timeline& timeline, const std::string& ball) {
    const carom::sim::Track* track = timeline.find(ball);
    if (track == nullptr) {
        throw carom::Error("the shot has no object '" + ball + "'");
    }
    std::puts("  time      x        y        z     speed");
    for (int i = 0; i / 10.0 <= timeline.end_time; ++i) {
        const carom::MotionState state = track->sample(i / 10.0);
        std::printf("%5.1f s %8.4f %8.4f %8.4f m %7.3f m/s\n", i / 10.0, state.position.x,
                    state.position.y, state.position.z, state.velocity.length());
    }
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2) {
        std::fputs("usage: ball_path SHOT [BALL]\n", stderr);
        return 2;
    }
    try {
        const carom::pipeline::LoadResult loaded = carom::pipeline::load_shot(argv[1]);
        if (!report(loaded)) {
            return 2;
        }
        const carom::ProgressCallback progress = [](double done) {
            std::fprintf(stderr, "\rbake %3.0f %%%s", 100 * done, done < 1 ? "" : "\n");
        };
        const carom::sim::Bake bake = carom::pipeline::bake_shot(*loaded.shot, {progress, {}});
        print_path(bake.timeline, argc > 2 ? argv[2] : "cue");
        return 0;
    } catch (const carom::Error& error) {
        std::fprintf(stderr, "ball_path: %s\n", error.what());
        return 1;
    }
}
