// The table of keys: the keys of each map of the format as data, and how their values are stored in
// the C++ fields of the same names. The parser, docs/reference.md and the JSON Schema use this
// table.
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
    bool (*is_excluding)(const Node& value);  // whether this value of `by` excludes the key
    std::string unless;                       // a third key that lifts the exclusion; may be empty
    std::string reason;  // the message after the quoted key; {} stands for the label of the map
};

/// A key of a map.
struct KeyInfo {
    std::string name;
    TypeInfo type;
    std::string default_text;  // as a user would type it; empty: no default
    std::string description;
    bool is_required = false;
    /// A map, perhaps among other alternatives, whose keys have defaults even if it is missing.
    bool is_always_there = false;
    /// The key has a meaning only together with one of these; if empty, always. See MapInfo::kinds.
    std::vector<std::string> goes_with{};
    bool is_needed_there = false;  // the keys of `goes_with` require it
    std::vector<Exclusion> exclusions{};
};

/// Keys that depend on each other.
struct KeyGroup {
    enum class Rule {
        exactly_one,
        exactly_one_or_solved,  // `solve` finds it where none is given
        at_most_one
    } rule = Rule::exactly_one;
    std::vector<std::string> keys;
};

/// A map of the format without its C++ type.
struct MapInfo {
    std::string name;  // heading in the reference: "strike"
    std::string description;
    std::vector<KeyInfo> keys;
    std::vector<KeyGroup> groups;
    /// Keys that each decide the kind of the object ("a sphere light"). The first one given decides
    /// which other keys have a meaning.
    std::vector<std::string> kinds;
    /// Keys that a user may expect, and why there are none: the message after the quoted key.
    std::vector<std::pair<std::string, std::string>> refused{};

    [[nodiscard]] std::vector<std::string> key_names() const;
};

/// Reads a node into the object at `value`. Returns false after it reported a problem; the object
/// is then unchanged. The type does not depend on the object's, so that the compiler generates the
/// code that copies and calls such functions only once.
using ReadFunction = std::function<bool(Reader&, const Node&, void* value)>;

/// Reads a V: a ReadFunction that is constructed from, and called like, a function that returns
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
    /// Formats a value as a user would type it; may be empty (then the reference omits the
    /// default).
    std::function<std::string(const V&)> show;
};

/// The keys of a map and how each is read, independent of the C++ type that the map fills, so that
/// the compiler generates little code for each key of each type.
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
    /// Adds a key whose value is stored `offset` bytes from the start of the target.
    void add_field(std::string_view name, const TypeInfo& type, std::string_view default_text,
                   std::string_view description, ReadFunction read, std::ptrdiff_t offset);
    /// Adds a nested map whose keys are read directly into the target.
    void add_map(std::string_view name, const MapInfo& map, std::string_view description,
                 Step read);
    // The following four apply to the key that was added last.
    void keep_last();
    void require_last();
    void pair_last(std::vector<std::string> partners, bool is_needed);
    void exclude_last(Exclusion exclusion);
    void add_group(KeyGroup::Rule rule, std::vector<std::string> keys);
    void set_kinds(std::vector<std::string> keys);
    void refuse(std::string_view name, std::string_view reason);
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

    /// As `key`, for a value that is not a single field: `set` takes (T&, V).
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

    /// A nested map that is read directly into the field: keys that are not given keep the field's
    /// values. `spec` must outlive this object (all of them are static).
    template <class Access, class U>
    MapSpec& map(std::string_view name, Access access, const MapSpec<U>& spec,
                 std::string_view description) {
        table_.add_map(name, spec.info(), description,
                       [access, &spec](Reader& reader, const Node& node, void* target) {
                           spec.read(reader, node, std::invoke(access, *static_cast<T*>(target)));
                       });
        return *this;
    }

    /// The key added last is required and therefore has no default.
    MapSpec& required() {
        table_.require_last();
        return *this;
    }

    /// The keys of the map that was added last have their defaults even if the map is missing.
    MapSpec& always_there() {
        table_.keep_last();
        return *this;
    }

    /// The key added last has a meaning only together with one of `partners`.
    MapSpec& goes_with(std::vector<std::string> partners) {
        table_.pair_last(std::move(partners), false);
        return *this;
    }

    /// The key added last has a meaning only together with one of `partners`, which require it.
    MapSpec& needed_by(std::vector<std::string> partners) {
        table_.pair_last(std::move(partners), true);
        return *this;
    }
    MapSpec& needed_by(const char* partner) { return needed_by(std::vector<std::string>{partner}); }

    /// The key added last cannot be given together with some values of another key.
    MapSpec& excluded_by(Exclusion exclusion) {
        table_.exclude_last(std::move(exclusion));
        return *this;
    }

    /// Keys that decide the kind of the map. Messages name the kind by its key: "a sphere light".
    MapSpec& kinds(std::vector<std::string> keys) {
        table_.set_kinds(std::move(keys));
        return *this;
    }

    MapSpec& exactly_one_of(std::vector<std::string> keys) {
        table_.add_group(KeyGroup::Rule::exactly_one, std::move(keys));
        return *this;
    }

    MapSpec& exactly_one_or_solved(std::vector<std::string> keys) {
        table_.add_group(KeyGroup::Rule::exactly_one_or_solved, std::move(keys));
        return *this;
    }

    MapSpec& at_most_one_of(std::vector<std::string> keys) {
        table_.add_group(KeyGroup::Rule::at_most_one, std::move(keys));
        return *this;
    }

    /// A key that a user may expect does not exist. `reason`: the message after the quoted key.
    MapSpec& refuse(std::string_view name, std::string_view reason) {
        table_.refuse(name, reason);
        return *this;
    }

    /// Adds a check of several keys together; called after all of them have been read.
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
    /// The offset of a field of the prototype, in bytes.
    [[nodiscard]] std::ptrdiff_t offset_of(const void* field) const {
        return static_cast<const char*>(field) -
               static_cast<const char*>(static_cast<const void*>(&prototype_));
    }

    KeyTable table_;
    T prototype_;
};

}  // namespace carom::pipeline::config
