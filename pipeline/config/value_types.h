// The types of values that keys may have, as building blocks.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "pipeline/camera/rational.h"
#include "pipeline/config/map_spec.h"
#include "sim/timeline/vocabulary.h"

namespace carom::pipeline::config {

// ---- ranges ---------------------------------------------------------------------------------

inline Range any() {
    return {};
}
inline Range at_least(double low) {
    return {low, {}, false, false};
}
inline Range more_than(double low) {
    return {low, {}, true, false};
}
inline Range between(double low, double high) {
    return {low, high, false, false};
}
inline Range above_up_to(double low, double high) {
    return {low, high, true, false};
}
inline Range from_below(double low, double high) {
    return {low, high, false, true};
}
inline Range inside(double low, double high) {
    return {low, high, true, true};
}

// ---- scalars --------------------------------------------------------------------------------

/// A number with a unit of `dimension`, or a plain one in SI units.
[[nodiscard]] ValueType<double> quantity(Dimension dimension, Range range = {});
[[nodiscard]] inline ValueType<double> number(Range range = {}) {
    return quantity(Dimension::none, range);
}
[[nodiscard]] inline ValueType<double> length(Range range = {}) {
    return quantity(Dimension::length, range);
}
[[nodiscard]] inline ValueType<double> time(Range range = {}) {
    return quantity(Dimension::time, range);
}
[[nodiscard]] inline ValueType<double> angle(Range range = {}) {
    return quantity(Dimension::angle, range);
}

/// The quantity's exact value where its terms are at most 1e9, else the nearest simple fraction.
[[nodiscard]] Rational to_rational(const Quantity& quantity);

/// A time or frequency kept exactly: "1/48 s", "24000/1001".
[[nodiscard]] ValueType<Rational> exact(Dimension dimension, Range range = {});

[[nodiscard]] ValueType<std::int64_t> integer64(std::int64_t low, std::int64_t high);
[[nodiscard]] ValueType<int> integer(int low, int high);
[[nodiscard]] ValueType<bool> boolean();

/// Any word; `noun` says what it stands for.
[[nodiscard]] ValueType<std::string> text(std::string noun);

/// The name of something in the shot; checked once everything is read.
[[nodiscard]] ValueType<std::string> name_of(ReferenceKind kind);

/// An existing file, as an absolute path.
[[nodiscard]] ValueType<std::string> file();

/// The quantity that a scalar holds, if it is one of this dimension and range; problems go to the
/// reader. For types that are made of several.
[[nodiscard]] std::optional<Quantity> read_quantity(Reader& reader, const Node& node,
                                                    const TypeInfo& type);

/// The index of the scalar in `type.choices`.
[[nodiscard]] std::optional<std::size_t> read_choice(Reader& reader, const Node& node,
                                                     const TypeInfo& type);

/// One of a few words.
template <class E>
ValueType<E> choice(std::vector<std::pair<std::string, E>> choices) {
    TypeInfo type;
    type.kind = TypeInfo::Kind::choice;
    for (const auto& [word, value] : choices) {
        type.choices.push_back(word);
    }
    ValueType<E> result;
    result.info = type;
    result.read = [type, choices](Reader& reader, const Node& node) -> std::optional<E> {
        const std::optional<std::size_t> index = read_choice(reader, node, type);
        return index ? std::optional<E>(choices[*index].second) : std::nullopt;
    };
    result.show = [choices](const E& shown) {
        for (const auto& [word, value] : choices) {
            if (value == shown) {
                return word;
            }
        }
        return std::string();
    };
    return result;
}

// ---- lists ----------------------------------------------------------------------------------

/// Whether `node` is a list of the allowed length; says what is wrong otherwise.
[[nodiscard]] bool check_list(Reader& reader, const Node& node, const TypeInfo& type);

/// `fewest` to `most` values of one type; most -1: any number.
template <class V>
ValueType<std::vector<V>> list_of(ValueType<V> element, int fewest = 0, int most = -1) {
    ValueType<std::vector<V>> result;
    result.info.kind = TypeInfo::Kind::list;
    result.info.elements = {element.info};
    result.info.fewest = fewest;
    result.info.most = most;
    const TypeInfo type = result.info;
    result.read = [type, element](Reader& reader,
                                  const Node& node) -> std::optional<std::vector<V>> {
        if (!check_list(reader, node, type)) {
            return std::nullopt;
        }
        std::vector<V> values;
        for (std::size_t i = 0; i < node.items.size(); ++i) {
            const Reader::Scope scope(reader, i, node.items[i].place);
            if (std::optional<V> value = element.read(reader, node.items[i])) {
                values.push_back(std::move(*value));
            }
        }
        return values.size() == node.items.size() ? std::optional(std::move(values)) : std::nullopt;
    };
    result.show = [element](const std::vector<V>& values) {
        std::string shown = "[";
        for (const V& value : values) {
            shown += (shown.size() > 1 ? ", " : "") + (element.show ? element.show(value) : "");
        }
        return shown + "]";
    };
    return result;
}

[[nodiscard]] ValueType<Vec3> vector3(Dimension dimension, Range range = {});
[[nodiscard]] ValueType<Vec2> vector2(Dimension dimension, Range range = {});

/// Two or three coordinates; without the third z is 0.
struct Coordinates {
    Vec3 value;
    bool has_z = false;
};
[[nodiscard]] ValueType<Coordinates> coordinates(Dimension dimension);

/// Linear red, green and blue in `range`, one number for grey, or "#rrggbb" (sRGB-encoded).
[[nodiscard]] ValueType<Vec3> colour(Range range);

// ---- alternatives ---------------------------------------------------------------------------

template <class V>
struct Alternative {
    std::function<bool(const Node&)> accepts;
    ValueType<V> type;
};

/// The first alternative that accepts the node reads it.
template <class V>
ValueType<V> any_of(std::vector<Alternative<V>> alternatives) {
    ValueType<V> result;
    result.info.kind = TypeInfo::Kind::any_of;
    for (const Alternative<V>& alternative : alternatives) {
        result.info.elements.push_back(alternative.type.info);
    }
    const TypeInfo type = result.info;
    result.read = [type, alternatives](Reader& reader, const Node& node) -> std::optional<V> {
        for (const Alternative<V>& alternative : alternatives) {
            if (alternative.accepts(node)) {
                return alternative.type.read(reader, node);
            }
        }
        reader.wrong_type(node, describe(type));
        return std::nullopt;
    };
    result.show = alternatives.front().type.show;
    return result;
}

inline bool is_scalar(const Node& node) {
    return node.is_scalar();
}
inline bool is_list(const Node& node) {
    return node.is_sequence();
}
inline bool is_map(const Node& node) {
    return node.is_map();
}
inline bool is_number(const Node& node) {
    return node.is_scalar() && looks_like_number(node.text);
}
inline bool is_word(const Node& node) {
    return node.is_scalar() && !looks_like_number(node.text);
}

/// The value of `from` carried into another type.
template <class To, class From, class Convert>
ValueType<To> convert(ValueType<From> from, Convert function) {
    ValueType<To> result;
    result.info = from.info;
    auto read = from.read;
    result.read = [read, function](Reader& reader, const Node& node) -> std::optional<To> {
        std::optional<From> value = read(reader, node);
        return value ? std::optional<To>(function(std::move(*value))) : std::nullopt;
    };
    return result;
}

// ---- maps -----------------------------------------------------------------------------------

/// A map of keys. `spec` must outlive the type (they are all static).
template <class T>
ValueType<T> record(const MapSpec<T>& spec) {
    ValueType<T> result;
    result.info.kind = TypeInfo::Kind::map;
    result.info.map = &spec.info();
    result.read = [&spec](Reader& reader, const Node& node) -> std::optional<T> {
        T value = spec.prototype();
        spec.read(reader, node, value);
        return node.is_map() ? std::optional<T>(std::move(value)) : std::nullopt;
    };
    return result;
}

/// Something with a name that the user chose, and the place of that name.
template <class T>
struct Named {
    std::string name;
    Place place;
    T value;
};

/// Whether a name can be used in paths of keys and references.
[[nodiscard]] bool check_name(Reader& reader, const std::string& name, const Place& place,
                              const std::string& noun);

/// A list of maps of keys, called "camera 1" or, by its key `name`, "camera 'opening'".
template <class T>
ValueType<std::vector<T>> numbered(const std::string& noun, const MapSpec<T>& spec) {
    ValueType<std::vector<T>> result;
    result.info.kind = TypeInfo::Kind::list;
    result.info.noun = noun;
    result.info.elements = {record(spec).info};
    const TypeInfo type = result.info;
    result.read = [noun, type, &spec](Reader& reader,
                                      const Node& node) -> std::optional<std::vector<T>> {
        if (!check_list(reader, node, type)) {
            return std::nullopt;
        }
        std::vector<T> all;
        for (std::size_t i = 0; i < node.items.size(); ++i) {
            const Node& item = node.items[i];
            const Reader::Scope scope(reader, i, item.place);
            const Entry* name = item.find("name");
            reader.set_label(name != nullptr && name->value.is_scalar()
                                 ? noun + " '" + name->value.text + "'"
                                 : noun + " " + std::to_string(i + 1));
            all.push_back(spec.prototype());
            spec.read(reader, item, all.back());
        }
        return all;
    };
    return result;
}

/// A map from names to maps of keys, in the order of the file. `noun` is "ball", "light" ...
template <class T>
ValueType<std::vector<Named<T>>> named(const std::string& noun, const MapSpec<T>& spec) {
    ValueType<std::vector<Named<T>>> result;
    result.info.kind = TypeInfo::Kind::named;
    result.info.noun = noun;
    result.info.elements = {record(spec).info};
    result.read = [noun, &spec](Reader& reader,
                                const Node& node) -> std::optional<std::vector<Named<T>>> {
        if (!node.is_map()) {
            reader.wrong_type(node, "a map from names to " + noun + "s");
            return std::nullopt;
        }
        std::vector<Named<T>> all;
        for (const Entry& entry : node.entries) {
            const Reader::Scope scope(reader, entry.key, entry.key_place);
            reader.set_label(noun + " '" + entry.key + "'");
            if (!check_name(reader, entry.key, entry.key_place, noun)) {
                continue;
            }
            all.push_back({entry.key, entry.key_place, spec.prototype()});
            if (!entry.value.is_null()) {
                spec.read(reader, entry.value, all.back().value);
            } else {
                reader.error(entry.key_place, reader.label() + " has no value");
            }
        }
        return all;
    };
    return result;
}

}  // namespace carom::pipeline::config
