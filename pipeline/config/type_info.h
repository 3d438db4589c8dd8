// The type of a key's value as data, for messages, the reference and the JSON Schema.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pipeline/config/units.h"

namespace carom::pipeline::config {

struct MapInfo;

/// An interval of numbers, in SI units; missing ends are unbounded.
struct Range {
    std::optional<double> low;
    std::optional<double> high;
    bool low_open = false;  // the end is excluded
    bool high_open = false;

    [[nodiscard]] bool contains(double value) const;
};

struct TypeInfo {
    enum class Kind {
        boolean,
        integer,
        quantity,  // a number with `dimension` and `range`
        text,      // any word
        name,      // a name in the shot; `noun` says of what
        file,
        choice,    // one of `choices`
        list,      // `elements[0]`, `fewest` to `most` times
        named,     // a map from the user's names to `elements[0]`
        settings,  // a map from key paths to any values
        map,       // `map`
        any_of,    // one of `elements`
    };
    // Defined in type_info.cpp, so that files that copy a TypeInfo do not generate them again.
    TypeInfo();
    TypeInfo(const TypeInfo&);
    TypeInfo(TypeInfo&&) noexcept;
    TypeInfo& operator=(const TypeInfo&);
    TypeInfo& operator=(TypeInfo&&) noexcept;
    ~TypeInfo();

    Kind kind = Kind::text;
    Dimension dimension = Dimension::none;
    Range range;
    std::string needed_unit;  // quantity: a suitable unit if plain numbers are rejected, or empty
    std::vector<std::string> choices;  // choice: all of them; text: some, to be suggested
    std::string more_choices;  // text: the map of the shot whose keys are choices, too ("a.b")
    std::vector<TypeInfo> elements;
    int fewest = 0;
    int most = -1;        // -1: any number
    std::string pattern;  // text: a regular expression that it matches; empty: any text
    std::string noun;     // text: what it means; name, named: what is named; any_of: its name
    const MapInfo* map = nullptr;
};

/// "more than 0 s and at most 3600 s"; empty for a range without ends.
[[nodiscard]] std::string describe(const Range& range, Dimension dimension);

/// "a length (m, cm, mm, in, ft)", "a list of 3 lengths", "true or false": to follow "must be".
[[nodiscard]] std::string describe(const TypeInfo& type);

}  // namespace carom::pipeline::config
