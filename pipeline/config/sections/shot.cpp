#include <utility>

#include "pipeline/config/sections/sections.h"
#include "pipeline/config/sections/solve.h"

namespace carom::pipeline::config {

namespace {

/// Adds keys that are removed before the sections are read (gather.h); they are here for the
/// reference.
void add_file_keys(MapSpec<ShotFile>& s) {
    const auto ignore = [](ShotFile&, const auto&) {};
    s.set("carom", integer(1, 1), ignore, "version of the format").required();
    const auto file_name = text("the name of a file");
    const auto one = convert<std::vector<std::string>>(
        file_name, [](std::string name) { return std::vector<std::string>{std::move(name)}; });
    s.set("include",
          any_of<std::vector<std::string>>({{is_scalar, one}, {is_list, list_of(file_name)}}),
          ignore,
          "files whose keys this file inherits, in their order. Maps are merged key by key, other "
          "values are replaced, and null removes a key");
    s.set("quality", text("the name of a preset"), ignore,
          "`draft`, `preview` or `final`: a preset whose keys the shot inherits and may replace");
}

}  // namespace

const MapSpec<ShotFile>& shot_spec() {
    static const MapSpec<ShotFile> spec = [] {
        MapSpec<ShotFile> s("shot", "The whole file.");
        add_file_keys(s);
        s.map("simulation", &ShotFile::world, simulation_spec(),
              "duration, time step and seed of the simulation");
        s.map("physics", &ShotFile::world, physics_spec(), "gravity and contacts");
        s.set(
            "conditions", record(conditions_spec()), [](ShotFile&, NotStored) {},
            "the numbers of the words that `physics` uses for the condition of the table, the "
            "balls and the stick");
        s.map("ball_set", &ShotFile::ball_set, ball_set_spec(), "properties that all balls share");
        s.key("table", &ShotFile::table, record(table_spec()), "the billiard table");
        s.key("set", &ShotFile::set, set_of_shot(),
              "the room around the table: the name of a set (`club`), a file with its objects, "
              "materials, lights and look, whose keys the shot inherits and may replace, or a map");
        s.key("rack", &ShotFile::rack, record(rack_spec()), "the object balls of a game");
        s.key("balls", &ShotFile::balls, named("ball", ball_spec()), "individual balls");
        s.key("objects", &ShotFile::objects, named("object", object_spec()), "other objects");
        s.key("events", &ShotFile::events, numbered("event", event_spec()),
              "actions on balls and objects");
        const auto one_solve = convert<std::vector<SolveSection>>(
            record(solve_spec()), [](SolveSection one) { return std::vector{std::move(one)}; });
        s.key("solve", &ShotFile::solve,
              any_of<std::vector<SolveSection>>(
                  {{[](const Node& node) { return node.is_map(); }, one_solve},
                   {is_list, numbered("solve", solve_spec())}}),
              "strikes that are found by what they shall bring about; of several, each is found "
              "with those before it as they are");
        s.key("stick", &ShotFile::stick, cue_stick(),
              "whether a cue stick is seen to strike: `shown` or `hidden` (the default), or its "
              "measures. A strike may say otherwise");
        s.key(
            "respot",
            [](ShotFile& shot) -> std::optional<sim::billiards::Game>& {
                return shot.world.respot;
            },
            choice<sim::billiards::Game>({{"snooker", sim::billiards::Game::snooker},
                                          {"eight_ball", sim::billiards::Game::eight_ball},
                                          {"nine_ball", sim::billiards::Game::nine_ball},
                                          {"carom", sim::billiards::Game::carom}}),
            "the game whose rules put balls back whenever everything rests. By default none come "
            "back");
        s.set(
            "materials", named("material", material_spec()),
            [](ShotFile& shot, auto value) { shot.materials = std::move(value); },
            "materials of surfaces");
        s.key("lights", &ShotFile::lights, lights(),
              "light sources. Without any, the scene has a lamp above the table and a dim room");
        s.key("cameras", &ShotFile::cameras, numbered("camera", camera_spec()),
              "cameras, each with its interval of the film");
        s.map("render", &ShotFile::render, render_spec(), "how frames are computed");
        s.map("output", &ShotFile::output, output_spec(), "how the frames become a film");
        s.key("sound", &ShotFile::sound, film_sound(),
              "`none` for a silent film, or how its sound is computed")
            .always_there();
        s.key("annotations", &ShotFile::annotations, numbered("annotation", annotation_spec()),
              "graphics on the finished frames: paths, arrows, angles, texts, a plan");
        s.set(
            "film", record(film_spec()), [](ShotFile&, const FilmSection&) {},
            "several shots as one film, instead of a shot: render, mux, frame, contact-sheet, "
            "plan, info and check take such a file");
        s.check([](Reader& reader, const Node& node, ShotFile& shot) {
            if (const Entry* film = node.find("film")) {
                reader.error(film->key_place,
                             "this is a film of several shots, where a single shot is needed");
            }
            const Entry* cameras = node.find("cameras");
            shot.cameras_place = cameras != nullptr ? cameras->key_place : reader.key_place();
        });
        return s;
    }();
    return spec;
}

}  // namespace carom::pipeline::config
