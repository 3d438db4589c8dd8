// What the simulation would refuse and no key's own check could know.
#include <string>

#include "pipeline/config/build/builder.h"

namespace carom::pipeline::config {

namespace {

/// The place that a sentence of the simulation is about: a pair of materials by the key that it
/// begins with, a body by its quoted name.
Place place_of(const std::string& problem, const Builder& builder) {
    for (const char* key : {"ball_cloth", "ball_ball", "ball_cushion"}) {
        if (problem.starts_with(key)) {
            const bool is_model = problem.find("model") != std::string::npos;
            return builder.place_of({"physics", key, is_model ? "model" : ""});
        }
    }
    for (const auto& [name, place] : builder.placed) {
        if (problem.find("'" + name + "'") != std::string::npos) {
            return place;
        }
    }
    return builder.root.place;
}

}  // namespace

void check_world(Builder& builder) {
    if (builder.reader.has_error()) {
        return;  // the same again in other words
    }
    for (const std::string& problem : sim::find_problems(builder.shot.world)) {
        builder.reader.error(place_of(problem, builder), problem);
    }
}

}  // namespace carom::pipeline::config
