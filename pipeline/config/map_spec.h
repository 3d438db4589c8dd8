// The table of keys: what each map of the format may hold, as data, and how its values reach the
// C++ fields of the same names. The parser, docs/reference.md and the JSON Schema read this table.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "pipeline/config/node.h"
#include "pipeline/config/reader.h"
#include "pipeline/config/type_info.h"

namespace carom::pipeline::config {

/// A value of another key of the same map that excludes a key.
struct Exclusion {
    std::string by;                           // the other key
    bool (*is_excluding)(const Node& value);  // of that key
    std::string unless;  // a third key: beside it nothing is excluded; may be empty
    std::string reason;  // what follows "'scale' "; {}: the label of the map
};

/// A key of a map.
struct KeyInfo {
    std::string name;
    TypeInfo type;
    std::string default_text;  // as it would be typed; empty: none
    std::string description;
    bool is_required = false;
    bool is_always_there = false;  // a map whose keys have their defaults even if it is not given
    /// It has a meaning only beside one of these keys; empty: it always has. See MapInfo::kinds.
    std::vector<std::string> goes_with{};
    bool is_needed_there = false;  // and it is required beside them
    std::vector<Exclusion> exclusions{};
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
    /// Keys that each make it another kind of thing ("a sphere light"). The first that is given
    /// decides which keys have a meaning.
    std::vector<std::string> kinds;

    [[nodiscard]] std::vector<std::string> key_names() const;
};

/// Reads a node into the object at `value`; false after a problem was reported, and then the object
/// is as it was. Without the object's C++ type, so that the compiler generates what copies and
/// calls such functions once and not for each type.
using ReadFunction = std::function<bool(Reader&, const Node&, void* value)>;

/// How a V is read: a ReadFunction that is made from, and called like, a function that returns
/// std::optional<V>.
template <class V>
class ValueReader {
  public:
    ValueReader() = default;
    explicit ValueReader(ReadFunction read_into) : read_into_(std::move(read_into)) {}

    template <class Function>
    ValueReader& operator=(Function function) {
        read_into_ = [function](Reader& reader, const Node& node, void* value) {
            std::optional<V> read = function(reader, node);
            if (read) {
                *static_cast<V*>(value) = std::move(*read);
            }
            return read.has_value();
        };
        return *this;
    }

    std::optional<V> operator()(Reader& reader, const Node& node) const {
        std::optional<V> value(std::in_place);
        if (!read_into_(reader, node, &*value)) {
            value.reset();
        }
        return value;
    }

    [[nodiscard]] const ReadFunction& read_into() const { return read_into_; }

  private:
    ReadFunction read_into_;
};

/// A type of value: described, read and shown.
template <class V>
struct ValueType {
    TypeInfo info;
    ValueReader<V> read;  // empty after a problem was reported
    /// As it would be typed; may be empty (such defaults are left out of the reference).
    std::function<std::string(const V&)> show;
};

/// The keys of a map and how each is read, without the C++ type that the map fills. It keeps what
/// the compiler generates for each key of each type small.
class KeyTable {
  public:
    /// Reads a value into the object at `target`, or checks that object.
    using Step = std::function<void(Reader&, const Node&, void* target)>;

    KeyTable(std::string_view name, std::string_view description);
    KeyTable(const KeyTable&);
    KeyTable(KeyTable&&) noexcept;
    KeyTable& operator=(const KeyTable&) = delete;
    KeyTable& operator=(KeyTable&&) = delete;
    ~KeyTable();

    void add(std::string_view name, const TypeInfo& type, std::string_view default_text,
             std::string_view description, Step read);
    /// A key whose value is read into what is `offset` bytes into the target.
    void add_field(std::string_view name, const TypeInfo& type, std::string_view default_text,
                   std::string_view description, ReadFunction read, std::ptrdiff_t offset);
    /// A map of keys that is read in place.
    void add_map(std::string_view name, const MapInfo& map, std::string_view description,
                 Step read);
    // Of the key added last.
    void require_last();
    void pair_last(std::vector<std::string> partners, bool is_needed);
    void exclude_last(Exclusion exclusion);
    void add_group(KeyGroup::Rule rule, std::vector<std::string> keys);
    void set_kinds(std::vector<std::string> keys);
    void add_check(Step check);

    [[nodiscard]] const MapInfo& info() const { return info_; }

    void read(Reader& reader, const Node& node, void* target) const;

  private:
    MapInfo info_;
    std::vector<Step> steps_;  // one for each key
    std::vector<Step> checks_;
};

/// The keys of a map that fills a T. Built once, then only read.
template <class T>
class MapSpec {
  public:
    MapSpec(std::string_view name, std::string_view description, T prototype = {})
        : table_(name, description), prototype_(std::move(prototype)) {}

    /// `access` is a member pointer or a function from T& to the field (V or std::optional<V>).
    template <class Access, class V>
    MapSpec& key(std::string_view name, Access access, const ValueType<V>& type,
                 std::string_view description) {
        using Field = std::remove_reference_t<std::invoke_result_t<Access, T&>>;
        std::string default_text;
        if constexpr (std::is_same_v<Field, V>) {
            default_text = type.show ? type.show(std::invoke(access, prototype_)) : std::string();
        }
        if constexpr (std::is_member_object_pointer_v<Access> && std::is_same_v<Field, V>) {
            table_.add_field(name, type.info, default_text, description, type.read.read_into(),
                             offset_of(&std::invoke(access, prototype_)));
        } else {
            table_.add(name, type.info, default_text, description,
                       [access, read = type.read](Reader& reader, const Node& node, void* target) {
                           if (auto value = read(reader, node)) {
                               std::invoke(access, *static_cast<T*>(target)) = std::move(*value);
                           }
                       });
        }
        return *this;
    }

    /// The same for what is not one field: `set` takes (T&, V).
    template <class V, class Set>
    MapSpec& set(std::string_view name, const ValueType<V>& type, Set setter,
                 std::string_view description, std::string_view default_text = {}) {
        table_.add(name, type.info, default_text, description,
                   [setter, read = type.read](Reader& reader, const Node& node, void* target) {
                       if (auto value = read(reader, node)) {
                           setter(*static_cast<T*>(target), std::move(*value));
                       }
                   });
        return *this;
    }

    /// A map of keys read in place, so that what it leaves out keeps the field's value. `spec` must
    /// outlive this one (they are all static).
    template <class Access, class U>
    MapSpec& map(std::string_view name, Access access, const MapSpec<U>& spec,
                 std::string_view description) {
        table_.add_map(name, spec.info(), description,
                       [access, &spec](Reader& reader, const Node& node, void* target) {
                           spec.read(reader, node, std::invoke(access, *static_cast<T*>(target)));
                       });
        return *this;
    }

    /// The key added last must be there, and so has no default.
    MapSpec& required() {
        table_.require_last();
        return *this;
    }

    /// The key added last has a meaning only beside one of `partners`.
    MapSpec& goes_with(std::vector<std::string> partners) {
        table_.pair_last(std::move(partners), false);
        return *this;
    }

    /// The key added last has a meaning only beside `partner`, which needs it.
    MapSpec& needed_by(std::string partner) {
        table_.pair_last({std::move(partner)}, true);
        return *this;
    }

    /// The key added last cannot be given beside some values of another key.
    MapSpec& excluded_by(Exclusion exclusion) {
        table_.exclude_last(std::move(exclusion));
        return *this;
    }

    /// Messages say of which kind a map is by its key and the map's name: "a sphere light".
    MapSpec& kinds(std::vector<std::string> keys) {
        table_.set_kinds(std::move(keys));
        return *this;
    }

    MapSpec& exactly_one_of(std::vector<std::string> keys) {
        table_.add_group(KeyGroup::Rule::exactly_one, std::move(keys));
        return *this;
    }

    MapSpec& at_most_one_of(std::vector<std::string> keys) {
        table_.add_group(KeyGroup::Rule::at_most_one, std::move(keys));
        return *this;
    }

    /// What only holds between keys; called when all of them have been read.
    MapSpec& check(void (*function)(Reader&, const Node&, T&)) {
        table_.add_check([function](Reader& reader, const Node& node, void* target) {
            function(reader, node, *static_cast<T*>(target));
        });
        return *this;
    }

    [[nodiscard]] const MapInfo& info() const { return table_.info(); }
    [[nodiscard]] const T& prototype() const { return prototype_; }

    /// Reads the map `node` into `target`; its problems go to the reader.
    void read(Reader& reader, const Node& node, T& target) const {
        table_.read(reader, node, &target);
    }

  private:
    /// Of a field of the prototype.
    [[nodiscard]] std::ptrdiff_t offset_of(const void* field) const {
        return static_cast<const char*>(field) -
               static_cast<const char*>(static_cast<const void*>(&prototype_));
    }

    KeyTable table_;
    T prototype_;
};

}  // namespace carom::pipeline::config
