// The types of maps: maps of keys, numbered maps and named maps.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "pipeline/config/list_types.h"
#include "pipeline/config/map_spec.h"

namespace carom::pipeline::config {

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

/// The same of a map of keys that only this type has.
template <class T>
ValueType<T> record(std::shared_ptr<const MapSpec<T>> spec) {
    ValueType<T> result = record(*spec);
    result.read = [kept = std::move(spec), read = result.read](Reader& reader, const Node& node) {
        return read(reader, node);
    };
    return result;
}

/// A value with a name that the user chose, and the place of that name.
template <class T>
struct Named {
    std::string name;
    Place place;
    T value;
};

/// Checks that a name can be used in key paths and references, and reports a problem otherwise.
[[nodiscard]] bool check_name(Reader& reader, const std::string& name, const Place& place,
                              const std::string& noun);

/// A list of maps of keys. Messages call an element "camera 1" or, by its key `name`,
/// "camera 'opening'".
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
