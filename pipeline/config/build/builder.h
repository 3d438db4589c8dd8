// The steps of build_shot, in the order in which they run.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/diagnostic.h"
#include "pipeline/config/build/build_shot.h"
#include "pipeline/config/find_place.h"
#include "sim/billiards/table.h"

namespace carom::pipeline::config {

/// What the steps hand on to each other.
struct Builder {
    const ShotFile& file;
    const Node& root;
    Reader& reader;
    Shot shot;

    /// By name, where balls and objects were given (racked balls: the rack's key).
    std::map<std::string, Place> placed;
    std::set<std::string> balls;
    std::set<std::string> bodies;         // that the simulation moves
    std::set<std::string> fixed;          // that others collide with
    std::map<std::string, Vec3> scenery;  // seen only: where it stands
    std::set<std::string> keyed;          // moved by keys and seen only
    std::set<std::string> kinematic;      // moved by keys, pushing others
    std::set<std::string> materials;
    std::optional<sim::billiards::TableGeometry> table_geometry;

    /// The place of a key by its path, or of the last part of it that was given.
    [[nodiscard]] Place place_of(const std::vector<std::string>& path) const;

    /// A problem that the simulation or the renderer finds, at the value that it is about.
    void report(const Diagnostic& problem);

    /// Takes a name; false and a problem if it is taken.
    bool claim(const std::string& name, const Place& place, const std::string& noun);
};

/// What an event's `contact` may name beside objects: the surfaces of the event log.
[[nodiscard]] const std::vector<std::string>& surface_names();

void build_table(Builder& builder);  // its measures
void build_balls(Builder& builder);  // bodies and what is seen of them
void build_objects(Builder& builder);
void build_table_scene(Builder& builder);  // its geometry
void build_look(Builder& builder);         // materials and lights
void build_events(Builder& builder);
void build_film(Builder& builder);    // cameras, timing, render and output settings
void check_output(Builder& builder);  // what a film's file cannot be, what its overlay cannot show
void check_poster(Builder& builder);  // after the cameras, which say how long the film is
void check_references(Builder& builder);
void check_placement(Builder& builder);  // overlaps, balls in cushions
void warn_of_places(Builder& builder);   // balls far away or under the table
void warn_of_coplanar(Builder& builder);
void check_world(Builder& builder);  // what the simulation itself would refuse

/// The balls of the rack; none after a problem.
[[nodiscard]] std::vector<sim::billiards::PlacedBall> place_rack(Builder& builder);

/// Radius and mass of a ball: given, or else the set's (a mass follows the volume).
[[nodiscard]] BallMeasures measures_of_set(const ShotFile& file);

}  // namespace carom::pipeline::config
