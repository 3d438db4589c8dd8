#include "pipeline/config/build/build_shot.h"

#include <algorithm>
#include <utility>

#include "pipeline/config/build/builder.h"
#include "sim/timeline/surface.h"

namespace carom::pipeline::config {

Place Builder::place_of(const std::vector<std::string>& path) const {
    return find_place(root, path).place;
}

void Builder::report(const Diagnostic& problem) {
    FoundPlace found = find_place(root, path_of(problem, root));
    reader.error_at_path(found.place, problem.sentence, std::move(found.key_path));
}

bool Builder::claim_name(const std::string& name, const Place& place, const std::string& noun) {
    if (sim::is_surface(name)) {
        reader.error(place, noun + " '" + name +
                                "' has the name of a part of the table; choose another name");
        return false;
    }
    const auto [known, is_new] = placed.emplace(name, place);
    if (!is_new) {
        reader.error(place, "the name of " + noun + " '" + name + "' is already used (at " +
                                reader.sources().to_string(known->second) + ")");
    }
    return is_new;
}

namespace {

void build_bodies(Builder& builder) {
    builder.shot.world = builder.file.world;
    build_table(builder);
    build_balls(builder);
    build_objects(builder);
    place_touching_balls(builder);
    build_table_geometry(builder);
}

}  // namespace

Shot build_shot(const ShotFile& file, const Node& root, const std::string& name, Reader& reader,
                const BuildAids& aids, std::vector<FoundStrike>& found) {
    Builder builder(file, root, reader, aids);
    builder.shot.name = name;
    build_bodies(builder);
    build_table_scene(builder);
    build_stick(builder);
    build_look(builder);
    build_set(builder);
    build_events(builder);
    build_film(builder);
    build_annotations(builder);
    build_sound(builder);
    check_references(builder);
    check_placement(builder);
    check_world(builder);
    solve_strikes(builder);
    found = std::move(builder.found_strikes);
    warn_about_ball_positions(builder);
    warn_about_coplanar_surfaces(builder);
    warn_about_matte_names(builder);
    return std::move(builder.shot);
}

BuiltWorld build_world(const ShotFile& file, const Node& root, Reader& reader,
                       sim::billiards::TableMemo* tables) {
    Builder builder(file, root, reader, {tables, nullptr});
    builder.has_look = false;
    build_bodies(builder);
    build_events(builder);
    check_references(builder);
    check_placement(builder);
    check_world(builder);
    aim_strikes(builder);
    return {std::move(static_cast<BuiltNames&>(builder)), std::move(builder.shot.world)};
}

std::vector<sim::ForceEvent> build_events(const ShotFile& file, const Node& root, Reader& reader,
                                          const BuiltWorld& others) {
    Builder builder(file, root, reader, {});
    static_cast<BuiltNames&>(builder) = others.names;
    builder.has_look = false;
    builder.shot.world = others.world;
    builder.shot.world.events.clear();
    build_events(builder);
    check_references(builder);
    const bool places_balls =
        std::ranges::any_of(builder.shot.world.events, [](const sim::ForceEvent& event) {
            return std::holds_alternative<sim::PlaceBall>(event.action);
        });
    if (places_balls && !reader.has_error()) {
        check_placement(builder);
    }
    check_events(builder);
    aim_strikes(builder);
    return std::move(builder.shot.world.events);
}

}  // namespace carom::pipeline::config
