// The steps of build_shot, in the order in which they run.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/diagnostic.h"
#include "pipeline/config/build/build_shot.h"
#include "pipeline/config/find_place.h"
#include "sim/aim/find_aims.h"
#include "sim/billiards/table_memo.h"

namespace carom::pipeline::config {

/// The state that the steps share.
struct Builder : BuiltNames {
    Builder(const ShotFile& of, const Node& from, Reader& with, const BuildAids& aids)
        : file(of), root(from), reader(with), tables(aids.tables), answers(aids.answers) {}

    const ShotFile& file;
    const Node& root;
    Reader& reader;
    Shot shot;
    sim::billiards::TableMemo* tables = nullptr;  // tables that were built before, or null
    const solve::AnswerWork* answers = nullptr;   // of `solve`, or null
    bool has_look = true;                         // false: only the world is built
    std::vector<sim::AimedStrike> aims{};         // of the world's events
    std::vector<FoundStrike> found_strikes{};     // by `solve`

    /// The place of a key by its path, or of the last part of the path that was given.
    [[nodiscard]] Place place_of(const std::vector<std::string>& path) const;

    /// Reports a problem of the simulation or the renderer at the value to which it refers.
    void report(const Diagnostic& problem);

    /// Reserves a name; false, after a problem, if it is already used.
    bool claim_name(const std::string& name, const Place& place, const std::string& noun);
};

/// The place on the table, without a height; NaN if it is a spot that the table does not have,
/// which check_references reports.
[[nodiscard]] Vec2 place_on_table(const Builder& builder, const TablePlace& place);
[[nodiscard]] Vec2 place_of_spot(const Builder& builder, const std::string& spot);

void build_table(Builder& builder);  // the dimensions of the table
void build_balls(Builder& builder);  // bodies and scene objects
void build_objects(Builder& builder);
void place_touching_balls(Builder& builder);
void build_table_geometry(Builder& builder);
void build_table_scene(Builder& builder);  // what is seen of it
void build_stick(Builder& builder);        // the cue stick, if it is seen
void build_look(Builder& builder);         // materials and lights
void build_set(Builder& builder);          // what of the room is far, after all objects
void build_events(Builder& builder);
void build_film(Builder& builder);     // cameras, timing, render and output settings
void apply_denoise(Builder& builder);  // what it asks of the render settings
void check_output(Builder& builder);   // video format, overlay
void check_poster(Builder& builder);   // after the cameras, which determine the film's duration
void build_annotations(Builder& builder);
void build_sound(Builder& builder);  // after the bodies and the cameras
void check_references(Builder& builder);
void check_placement(Builder& builder);            // overlaps, balls in cushions
void warn_about_ball_positions(Builder& builder);  // far away or under the table
void warn_about_coplanar_surfaces(Builder& builder);
void warn_about_matte_names(Builder& builder);
void check_world(Builder& builder);   // problems that the simulation finds
void check_events(Builder& builder);  // those of the events alone
/// Finds the directions of the aims up to that event, if there is no error.
void aim_strikes(Builder& builder, std::size_t last_event = ~std::size_t{0});
/// Finds strikes for `solve`, each after the aims before it, and then the other aims.
void solve_strikes(Builder& builder);

/// The balls of the rack; empty after a problem.
[[nodiscard]] std::vector<sim::billiards::PlacedBall> place_rack(Builder& builder);

/// Radius and mass of the balls of the set. The default mass is proportional to the volume.
[[nodiscard]] BallMeasures measures_of_set(const ShotFile& file);

}  // namespace carom::pipeline::config
