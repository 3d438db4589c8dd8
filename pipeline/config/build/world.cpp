// Finds problems of the world that the checks of single keys cannot find.
#include <algorithm>
#include <string>
#include <vector>

#include "pipeline/config/build/builder.h"
#include "pipeline/config/surface_names.h"
#include "pipeline/config/text.h"

namespace carom::pipeline::config {

namespace {

/// Warns of a pair of physical materials that no object has, if the name is probably misspelt.
void check_pairs(Builder& builder) {
    std::vector<std::string> known{"ball"};
    known.insert(known.end(), surface_names().begin(), surface_names().end());
    for (const sim::Body& body : builder.shot.world.bodies) {
        known.push_back(body.material);
    }
    const Entry* physics = builder.root.find("physics");
    const Entry* pairs = physics != nullptr ? physics->value.find("pairs") : nullptr;
    if (pairs == nullptr) {
        return;
    }
    for (const Node& pair : pairs->value.items) {
        for (const Node& name : pair.find("between")->value.items) {
            const bool is_known = std::find(known.begin(), known.end(), name.text) != known.end();
            const Message help = hint(name.text, known);
            if (!is_known && !help.text.empty()) {
                builder.reader.warning(
                    name.place, "no object has the physical material " + quote(name.text) + help);
            }
        }
    }
}

}  // namespace

void check_world(Builder& builder) {
    if (builder.reader.has_error()) {
        return;  // the same problems would be reported twice
    }
    check_pairs(builder);
    for (const Diagnostic& problem : sim::find_problems(builder.shot.world)) {
        builder.report(problem);
    }
}

}  // namespace carom::pipeline::config
