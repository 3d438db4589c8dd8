// Builds a Shot from the sections of the YAML: resolves names, builds geometry, fills in defaults.
#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "pipeline/config/node.h"
#include "pipeline/config/reader.h"
#include "pipeline/config/shot_file.h"
#include "pipeline/shot/shot.h"
#include "pipeline/solve/answers.h"
#include "sim/billiards/table_memo.h"

namespace carom::pipeline::config {

/// See LoadOptions; each may be null.
struct BuildAids {
    sim::billiards::TableMemo* tables = nullptr;
    const solve::AnswerWork* answers = nullptr;
};

/// Problems go to the reader; after an error the shot is invalid. `root` is the tree from which
/// `file` was read, for places. `found` gets the strikes that were found for `solve`.
[[nodiscard]] Shot build_shot(const ShotFile& file, const Node& root, const std::string& name,
                              Reader& reader, const BuildAids& aids,
                              std::vector<FoundStrike>& found);

/// What a shot consists of, by name.
struct BuiltNames {
    /// The places of balls and objects (racked balls: the place of the rack).
    std::map<std::string, Place> placed;
    std::set<std::string> balls;
    std::set<std::string> bodies;         // moved by the simulation
    std::set<std::string> fixed;          // static collision objects
    std::map<std::string, Vec3> scenery;  // positions of static objects that are only visible
    std::set<std::string> keyed;          // moved by keys and only visible
    std::set<std::string> kinematic;      // moved by keys and pushing others
    std::set<std::string> materials;
    std::shared_ptr<const sim::billiards::TableGeometry> table_geometry;  // null: no table
};

/// A world without what is only seen, and the names in it.
struct BuiltWorld {
    BuiltNames names;
    sim::WorldDescription world;
};

/// As build_shot, for the world alone; `file` needs only the sections that it is made of.
[[nodiscard]] BuiltWorld build_world(const ShotFile& file, const Node& root, Reader& reader,
                                     sim::billiards::TableMemo* tables);

/// Builds the events of `file` for another world, which has no other problems.
[[nodiscard]] std::vector<sim::ForceEvent> build_events(const ShotFile& file, const Node& root,
                                                        Reader& reader, const BuiltWorld& others);

}  // namespace carom::pipeline::config
