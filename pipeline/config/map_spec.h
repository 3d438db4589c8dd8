// The table of keys: what each map of the format may hold, as data, and how its values reach the
// C++ fields of the same names. The parser, docs/reference.md and the JSON Schema read this table.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "pipeline/config/node.h"
#include "pipeline/config/reader.h"
#include "pipeline/config/type_info.h"

namespace carom::pipeline::config {

/// A key of a map.
struct KeyInfo {
    std::string name;
    TypeInfo type;
    std::string default_text;  // as it would be typed; empty: none
    std::string description;
    bool is_required = false;
    bool is_always_there = false;  // a map whose keys have their defaults even if it is not given
};

/// Keys that depend on each other.
struct KeyGroup {
    enum class Rule { exactly_one, at_most_one } rule = Rule::exactly_one;
    std::vector<std::string> keys;
};

/// A map of the format without its C++ type.
struct MapInfo {
    std::string name;  // heading in the reference: "strike"
    std::string description;
    std::vector<KeyInfo> keys;
    std::vector<KeyGroup> groups;

    [[nodiscard]] std::vector<std::string> key_names() const;
};

/// A type of value: described, read and shown.
template <class V>
struct ValueType {
    TypeInfo info;
    /// Empty after a problem was reported.
    std::function<std::optional<V>(Reader&, const Node&)> read;
    /// As it would be typed; may be empty (such defaults are left out of the reference).
    std::function<std::string(const V&)> show;
};

/// Reports entries of `node` that `info` does not know, missing required keys and broken groups.
void check_keys(Reader& reader, const Node& node, const MapInfo& info);

namespace detail {

template <class T>
struct is_optional : std::false_type {};
template <class V>
struct is_optional<std::optional<V>> : std::true_type {};

}  // namespace detail

/// The keys of a map that fills a T. Built once, then only read.
template <class T>
class MapSpec {
  public:
    MapSpec(std::string name, std::string description, T prototype = {})
        : prototype_(std::move(prototype)) {
        info_.name = std::move(name);
        info_.description = std::move(description);
    }

    /// `access` is a member pointer or a function from T& to the field (V or std::optional<V>).
    template <class Access, class V>
    MapSpec& key(std::string name, Access access, ValueType<V> type, std::string description) {
        using Field = std::remove_reference_t<std::invoke_result_t<Access, T&>>;
        std::string default_text;
        if constexpr (std::is_same_v<Field, V>) {
            default_text = type.show ? type.show(std::invoke(access, prototype_)) : std::string();
        }
        auto read = type.read;
        return add({std::move(name), std::move(type.info), std::move(default_text),
                    std::move(description), false, false},
                   [access, read](Reader& reader, const Node& node, T& target) {
                       if (auto value = read(reader, node)) {
                           std::invoke(access, target) = std::move(*value);
                       }
                   });
    }

    /// The same for what is not one field: `set` takes (T&, V).
    template <class V, class Set>
    MapSpec& set(std::string name, ValueType<V> type, Set setter, std::string description,
                 std::string default_text = {}) {
        auto read = type.read;
        return add({std::move(name), std::move(type.info), std::move(default_text),
                    std::move(description), false, false},
                   [setter, read](Reader& reader, const Node& node, T& target) {
                       if (auto value = read(reader, node)) {
                           setter(target, std::move(*value));
                       }
                   });
    }

    /// A map of keys read in place, so that what it leaves out keeps the field's value. `spec` must
    /// outlive this one (they are all static).
    template <class Access, class U>
    MapSpec& map(std::string name, Access access, const MapSpec<U>& spec, std::string description) {
        TypeInfo type;
        type.kind = TypeInfo::Kind::map;
        type.map = &spec.info();
        return add({std::move(name), std::move(type), {}, std::move(description), false, true},
                   [access, &spec](Reader& reader, const Node& node, T& target) {
                       spec.read(reader, node, std::invoke(access, target));
                   });
    }

    /// The key added last must be there, and so has no default.
    MapSpec& required() {
        info_.keys.back().is_required = true;
        info_.keys.back().default_text.clear();
        return *this;
    }

    MapSpec& exactly_one_of(std::vector<std::string> keys) {
        info_.groups.push_back({KeyGroup::Rule::exactly_one, std::move(keys)});
        return *this;
    }

    MapSpec& at_most_one_of(std::vector<std::string> keys) {
        info_.groups.push_back({KeyGroup::Rule::at_most_one, std::move(keys)});
        return *this;
    }

    /// What only holds between keys; called when all of them have been read.
    MapSpec& check(std::function<void(Reader&, const Node&, T&)> check) {
        checks_.push_back(std::move(check));
        return *this;
    }

    [[nodiscard]] const MapInfo& info() const { return info_; }
    [[nodiscard]] const T& prototype() const { return prototype_; }

    /// Reads the map `node` into `target`; its problems go to the reader.
    void read(Reader& reader, const Node& node, T& target) const {
        if (!node.is_map()) {
            reader.wrong_type(node, "a map of keys");
            return;
        }
        check_keys(reader, node, info_);
        for (std::size_t i = 0; i < info_.keys.size(); ++i) {
            if (const Entry* entry = node.find(info_.keys[i].name)) {
                const Reader::Scope scope(reader, entry->key, entry->key_place);
                if (entry->value.is_null()) {
                    reader.error(entry->key_place, reader.value_name() + " has no value");
                    continue;
                }
                bindings_[i](reader, entry->value, target);
            }
        }
        for (const auto& check : checks_) {
            check(reader, node, target);
        }
    }

  private:
    using Binding = std::function<void(Reader&, const Node&, T&)>;

    MapSpec& add(KeyInfo key, Binding binding) {
        info_.keys.push_back(std::move(key));
        bindings_.push_back(std::move(binding));
        return *this;
    }

    MapInfo info_;
    std::vector<Binding> bindings_;
    std::vector<std::function<void(Reader&, const Node&, T&)>> checks_;
    T prototype_;
};

}  // namespace carom::pipeline::config
