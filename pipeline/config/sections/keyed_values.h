// Camera values that are given at several times of the film.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "pipeline/camera/camera_rig.h"
#include "pipeline/config/value_types.h"

namespace carom::pipeline::config {

/// A word, or the four numbers of a cubic Bezier curve.
[[nodiscard]] ValueType<Easing> easing();

/// A time of the film, s, exactly.
[[nodiscard]] ValueType<Rational> film_time();

/// Whether this is the map of a value that is given by keys.
[[nodiscard]] bool has_keys(const Node& node);

/// Reports a key that is not later than the one before it. `times`: those of the keys of `node`.
void check_key_order(Reader& reader, const Node& node, const std::vector<Rational>& times);

/// Warns of keys outside of the camera's interval of the film. `camera`: the camera's map. `key`:
/// the name of the value. `times`: those of its keys.
void warn_about_unreached_keys(Reader& reader, const Node& camera, const CameraRig& rig,
                               const std::string& key, const std::vector<Rational>& times);

template <class V>
std::vector<Rational> times_of(const std::vector<ValueKey<V>>& keys) {
    std::vector<Rational> times;
    times.reserve(keys.size());
    for (const ValueKey<V>& key : keys) {
        times.push_back(key.video_time);
    }
    return times;
}

/// A pair of film time and value.
template <class V>
ValueType<ValueKey<V>> value_key(const ValueType<V>& single) {
    const ValueType<Rational> time = film_time();
    TypeInfo either;
    either.kind = TypeInfo::Kind::any_of;
    either.elements = {time.info, single.info};
    ValueType<ValueKey<V>> result;
    result.info.kind = TypeInfo::Kind::list;
    result.info.elements = {either};
    result.info.fewest = result.info.most = 2;
    const TypeInfo type = result.info;
    result.read = [type, time, read = single.read](Reader& reader,
                                                   const Node& node) -> std::optional<ValueKey<V>> {
        if (!check_list(reader, node, type)) {
            return std::nullopt;
        }
        std::optional<Rational> at;
        std::optional<V> value;
        {
            const Reader::Scope scope(reader, std::size_t{0}, node.items[0].place);
            at = time.read(reader, node.items[0]);
        }
        {
            const Reader::Scope scope(reader, std::size_t{1}, node.items[1].place);
            value = read(reader, node.items[1]);
        }
        return at && value ? std::optional(ValueKey<V>{*at, std::move(*value)}) : std::nullopt;
    };
    return result;
}

/// A changing value that the keys of a map replace. (Imath's vectors are not initialised by
/// default.)
template <class V>
Eased<V> blank() {
    if constexpr (std::is_same_v<V, Vec3>) {
        return {Vec3(0, 0, 0), Vec3(0, 0, 0)};
    } else {
        return {};
    }
}

/// {keys, easing}.
template <class V>
ValueType<Eased<V>> keyed(const std::string& key, const ValueType<V>& single) {
    const auto spec = std::make_shared<MapSpec<Eased<V>>>(
        key + " at times",
        "A value that is given at times of the film. It is constant before the "
        "first time and after the last.",
        blank<V>());
    spec->key("keys", &Eased<V>::keys, list_of(value_key(single), 1, 256),
              "list of [film time, value] in order of time")
        .required();
    spec->key("easing", &Eased<V>::easing, easing(),
              "how the value changes from each key to the next, as for values that change from one "
              "end of the camera's interval to the other");
    spec->check([](Reader& reader, const Node& node, Eased<V>& value) {
        check_key_order(reader, node, times_of(value.keys));
        if (!value.keys.empty()) {
            value.start = value.keys.front().value;
            value.end = value.keys.back().value;
        }
    });
    return record<Eased<V>>(spec);
}

}  // namespace carom::pipeline::config
