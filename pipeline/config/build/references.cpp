#include <algorithm>
#include <vector>

#include "core/text.h"
#include "pipeline/config/build/builder.h"
#include "pipeline/config/pocket_names.h"
#include "pipeline/config/text.h"
#include "sim/billiards/spots.h"
#include "sim/timeline/surface.h"

namespace carom::pipeline::config {

namespace {

void append(std::vector<std::string>& names, const auto& more) {
    names.insert(names.end(), more.begin(), more.end());
}

std::vector<std::string> spot_names(const Builder& builder) {
    std::vector<std::string> names;
    if (builder.shot.world.table) {
        for (const auto& spot : sim::billiards::spots_of(*builder.shot.world.table)) {
            names.push_back(spot.name);
        }
    }
    return names;
}

/// All names of pockets.
std::vector<std::string> all_pocket_names(const Builder& builder) {
    const auto& table = builder.shot.world.table;
    std::vector<std::string> names;
    if (table) {
        append(names, pocket_names(*table));
        append(names, players_pocket_names(*table));
    }
    return names;
}

std::vector<std::string> known_names(const Builder& builder, ReferenceKind kind) {
    std::vector<std::string> names;
    switch (kind) {
        case ReferenceKind::ball:
            append(names, builder.balls);
            break;
        case ReferenceKind::material:
            append(names, builder.materials);
            break;
        case ReferenceKind::spot:
            return spot_names(builder);
        case ReferenceKind::pocket:
            return all_pocket_names(builder);
        case ReferenceKind::aimed:
            names = spot_names(builder);
            append(names, all_pocket_names(builder));
            [[fallthrough]];
        case ReferenceKind::placed:
            append(names, builder.bodies);
            append(names, builder.fixed);
            append(names, builder.kinematic);
            for (const auto& [name, position] : builder.scenery) {
                names.push_back(name);
            }
            break;
        case ReferenceKind::touchable:
            append(names, builder.bodies);
            append(names, builder.fixed);
            append(names, builder.kinematic);
            names.insert(names.end(), sim::surface_names().begin(), sim::surface_names().end());
            break;
        case ReferenceKind::body:
            append(names, builder.bodies);
            break;
        case ReferenceKind::simulated:
            append(names, builder.bodies);
            append(names, builder.kinematic);
            break;
        case ReferenceKind::moving:
            append(names, builder.bodies);
            append(names, builder.keyed);
            append(names, builder.kinematic);
            break;
    }
    return names;
}

std::string noun(ReferenceKind kind) {
    switch (kind) {
        case ReferenceKind::ball:
            return "ball";
        case ReferenceKind::material:
            return "material";
        case ReferenceKind::touchable:
            return "object or surface";
        case ReferenceKind::spot:
            return "spot";
        case ReferenceKind::pocket:
            return "pocket";
        case ReferenceKind::placed:
        case ReferenceKind::aimed:
        case ReferenceKind::body:
        case ReferenceKind::simulated:
        case ReferenceKind::moving:
            break;
    }
    return "ball or object";
}

/// The reason why an existing object cannot be referred to here; empty if the object does not
/// exist.
std::string wrong_kind(const Builder& builder, const Reference& reference) {
    const bool is_keyed = builder.keyed.count(reference.name) != 0;
    if (is_keyed && reference.kind != ReferenceKind::material) {
        return quote(reference.name) +
               " is moved by keys and only visible, so it is not part of the simulation";
    }
    const bool is_kinematic = builder.kinematic.count(reference.name) != 0;
    if (is_kinematic && reference.kind != ReferenceKind::material) {
        return quote(reference.name) + " is moved by keys, so nothing else can change its motion";
    }
    const bool is_static =
        builder.fixed.count(reference.name) != 0 || builder.scenery.count(reference.name) != 0;
    if (!is_static && builder.bodies.count(reference.name) == 0) {
        return {};
    }
    switch (reference.kind) {
        case ReferenceKind::ball:
            return quote(reference.name) + " is not a ball";
        case ReferenceKind::body:
        case ReferenceKind::simulated:
        case ReferenceKind::moving:
            return quote(reference.name) +
                   " does not move: only balls and objects with physics or keys have a path";
        case ReferenceKind::touchable:
            return quote(reference.name) + " has no physics, so nothing can touch it";
        case ReferenceKind::placed:
        case ReferenceKind::aimed:
        case ReferenceKind::spot:
        case ReferenceKind::pocket:
        case ReferenceKind::material:
            break;
    }
    return {};
}

/// The problem of a name that is no spot of the table.
Message unknown_spot(const Builder& builder, const std::string& name,
                     const std::vector<std::string>& known) {
    if (!builder.file.table) {
        return quote(name) + " would be a spot of the table, and the shot has no table";
    }
    if (known.empty()) {
        return quote(name) +
               " would be a spot of the table, and an unbounded cloth has none; give "
               "a point such as [0.5, 0.2]";
    }
    const Message help = hint(name, known);
    return {"there is no spot " + quote(name) + help.text + "; the spots of the table are " +
                enumerate(quoted(known), "and"),
            help.suggestion};
}

/// The problem of a name that is no pocket of the table.
Message unknown_pocket(const Builder& builder, const std::string& name,
                       const std::vector<std::string>& known) {
    if (!builder.file.table) {
        return quote(name) + " would be a pocket of the table, and the shot has no table";
    }
    if (known.empty()) {
        return quote(name) + " would be a pocket of the table, and this table has none";
    }
    const sim::billiards::TableMeasures& table = *builder.shot.world.table;
    if (const std::string own = ambiguous_pocket(table, name); !own.empty()) {
        return quote(name) + " is ambiguous: it is " + quote(own) +
               " in the plan, but players of snooker call the end of the black spot the top; say " +
               enumerate(quoted(pocket_names(table)), "or");
    }
    const Message help = hint(name, known);
    return {"there is no pocket " + quote(name) + help.text + "; the pockets of the table are " +
                enumerate(quoted(pocket_names(table)), "and"),
            help.suggestion};
}

}  // namespace

void check_references(Builder& builder) {
    for (const Reference& reference : builder.reader.references()) {
        if (reference.kind == ReferenceKind::material && !builder.has_look) {
            continue;
        }
        const std::vector<std::string> known = known_names(builder, reference.kind);
        if (std::find(known.begin(), known.end(), reference.name) != known.end()) {
            continue;
        }
        const bool is_spot = reference.kind == ReferenceKind::spot;
        const bool is_pocket = reference.kind == ReferenceKind::pocket;
        if ((is_spot || is_pocket) && builder.file.table && !builder.shot.world.table) {
            continue;  // the problem of the table was reported
        }
        Message message = is_spot     ? unknown_spot(builder, reference.name, known)
                          : is_pocket ? unknown_pocket(builder, reference.name, known)
                                      : wrong_kind(builder, reference);
        if (message.text.empty()) {
            message = "there is no " + noun(reference.kind) + " " + quote(reference.name) +
                      hint(reference.name, known);
        }
        builder.reader.error_at_path(reference.place, message, reference.key_path);
    }
}

}  // namespace carom::pipeline::config
