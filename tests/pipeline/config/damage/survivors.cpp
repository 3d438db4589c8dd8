#include "tests/pipeline/config/damage/survivors.h"

#include <variant>

#include "pipeline/config/quantity.h"

namespace carom::testing {

namespace {

using pipeline::config::Quantity;

/// A quantity became another valid one.
bool is_other_quantity(const Difference& difference, const Damage& /*damage*/) {
    const auto before = pipeline::config::parse_quantity(difference.before);
    const auto after = pipeline::config::parse_quantity(difference.after);
    return difference.is_scalar && std::holds_alternative<Quantity>(before) &&
           std::holds_alternative<Quantity>(after);
}

/// A text without meaning for the program changed.
bool is_other_text(const Difference& difference, const Damage& /*damage*/) {
    const std::string& path = difference.path;
    return difference.is_scalar && (path == "output.title" || path.ends_with("].name"));
}

/// Something without references to it has another name.
bool is_other_name(const Difference& difference, const Damage& /*damage*/) {
    const std::string& path = difference.path;
    return difference.is_renamed &&
           (path == "balls" || path == "objects" || path == "lights" || path == "materials");
}

/// A line was joined to the comment above it.
bool is_comment(const Difference& difference, const Damage& damage) {
    return joins_comment(damage) && !difference.is_scalar && difference.after.empty();
}

struct Kind {
    const char* name;
    bool (*holds)(const Difference&, const Damage&);
};

constexpr Kind kKinds[] = {
    {"another quantity", is_other_quantity},
    {"another text", is_other_text},
    {"another name", is_other_name},
    {"a comment", is_comment},
};

}  // namespace

namespace {

std::string parent_of(const std::string& path) {
    return path.substr(0, path.rfind('.'));
}

/// A key moved from a map to that map's parent or back. If maps are indented by one space, one
/// space more or less is enough.
bool is_other_parent(const std::vector<Difference>& differences, const Damage& damage) {
    if (differences.size() != 2 || !damage.what.starts_with("indentation")) {
        return false;
    }
    const bool gone_first = differences[0].after.empty();
    const Difference& gone = differences[gone_first ? 0 : 1];
    const Difference& come = differences[gone_first ? 1 : 0];
    const std::string from = parent_of(gone.path);
    const std::string into = parent_of(come.path);
    return !gone.before.empty() && gone.after.empty() && come.before.empty() &&
           gone.before == come.after && (parent_of(from) == into || parent_of(into) == from);
}

constexpr const char* kOtherParent = "another parent";

}  // namespace

bool joins_comment(const Damage& damage) {
    return damage.what.starts_with("line end") && !damage.what.ends_with("a line end") &&
           damage.old_line.find('#') != std::string::npos;
}

std::vector<std::string> survivor_kinds() {
    std::vector<std::string> names;
    for (const Kind& kind : kKinds) {
        names.emplace_back(kind.name);
    }
    names.emplace_back(kOtherParent);
    return names;
}

std::string survivor_kind(const std::vector<Difference>& differences, const Damage& damage) {
    if (is_other_parent(differences, damage)) {
        return kOtherParent;
    }
    if (differences.size() != 1) {
        return {};
    }
    for (const Kind& kind : kKinds) {
        if (kind.holds(differences[0], damage)) {
            return kind.name;
        }
    }
    return {};
}

}  // namespace carom::testing
