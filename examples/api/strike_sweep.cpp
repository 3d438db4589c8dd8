// strike_sweep SHOT FILM SECONDS: increases the speed of the strike until a ball is potted, renders
// a frame of that shot from another camera position, and writes a film. It stops after SECONDS.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>

#include <carom/film.h>

using namespace carom;

// Finds the slowest strike that pots a ball, from 1 m/s on in steps of 1 m/s.
static sim::Bake find_pot(pipeline::Shot& shot, const WorkContext& context) {
    auto& strike = std::get<sim::Strike>(shot.world.events.at(0).action);
    for (strike.speed = 1; *strike.speed <= 12; *strike.speed += 1) {
        sim::Bake bake = pipeline::bake_shot(shot, context);
        const auto potted =
            std::ranges::count(bake.timeline.events, sim::EventKind::potted, &sim::Event::kind);
        std::printf("%4.1f m/s pots %d\n", *strike.speed, static_cast<int>(potted));
        if (potted > 0) {
            return bake;
        }
    }
    throw Error("no strike pots a ball");
}

int main(int argc, char** argv) try {
    if (argc != 4) {
        throw Error("usage: strike_sweep SHOT FILM SECONDS");
    }
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(std::atoi(argv[3]));
    std::stop_source stop;  // can stop all work, from any thread
    const auto stop_in_time = [&](double /*done*/) {
        if (std::chrono::steady_clock::now() >= end) {
            stop.request_stop();
        }
    };
    auto loaded =
        pipeline::load_shot(argv[1], {.overrides = {"render.size=[160, 90]"}, .quality = "draft"});
    if (!loaded.shot) {
        throw Error(format(loaded.problems.front()));
    }
    pipeline::Shot& shot = *loaded.shot;
    const WorkContext context{stop_in_time, stop.get_token()};
    const sim::Bake bake = find_pot(shot, context);
    shot.cameras.front().position = pipeline::BezierPath{{{{-1.5, -1.5, 1.5}, {}, 0}}};  // m
    const render::Film frame = pipeline::make_frame_renderer(shot, bake.timeline)(0, context);
    std::printf("frame 0 has %d x %d pixels\n", frame.width, frame.height);
    const pipeline::JobObserver observer{[&](auto, double done) { stop_in_time(done); }, {}, {}};
    pipeline::FilmJobOptions options;
    options.output = argv[2];
    options.cache_folder = "strike_sweep_cache";
    options.frames = pipeline::parse_frame_range("0-23");
    const auto result = pipeline::make_film(shot, bake, options, observer, stop.get_token());
    std::printf("%s has %d frames\n", argv[2], static_cast<int>(result.frames));
} catch (const Error& error) {
    std::fprintf(stderr, "strike_sweep: %s\n", error.what());
    return 1;
}
