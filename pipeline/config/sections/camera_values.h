// The types of a camera's values: paths, easings and changing values.
#pragma once

#include <memory>
#include <string>

#include "pipeline/camera/camera_rig.h"
#include "pipeline/config/sections/keyed_values.h"
#include "pipeline/config/value_types.h"

namespace carom::pipeline::config {

/// A map that describes a path, or one fixed point.
[[nodiscard]] ValueType<CameraPath> camera_path();

/// One value, [start, end], {from, to, easing} or {keys, easing}. A value that is itself a list is
/// distinguished from a pair by its elements.
template <class V>
ValueType<Eased<V>> eased(const std::string& key, const ValueType<V>& single) {
    const auto spec = std::make_shared<MapSpec<Eased<V>>>(
        "changing " + key, "A value that changes during the camera's interval of the film.",
        blank<V>());
    spec->key("from", &Eased<V>::start, single, "value at the start").required();
    spec->key("to", &Eased<V>::end, single, "value at the end").required();
    spec->key(
        "easing", &Eased<V>::easing, easing(),
        "`smooth` starts and ends gently; [x1, y1, x2, y2] are the inner control points of a cubic "
        "Bezier curve from (0, 0) to (1, 1), value over time");
    const auto constant = convert<Eased<V>>(single, [](const V& value) {
        return Eased<V>{value, value, Easing::linear};
    });
    const auto pair = convert<Eased<V>>(list_of(single, 2, 2), [](const std::vector<V>& values) {
        return Eased<V>{values[0], values[1], Easing::linear};
    });
    const bool is_list_itself = single.info.kind == TypeInfo::Kind::list;
    const auto is_single = [is_list_itself](const Node& node) {
        return is_list_itself
                   ? node.is_sequence() && !node.items.empty() && !node.items.front().is_sequence()
                   : node.is_scalar();
    };
    ValueType<Eased<V>> result = any_of<Eased<V>>({{is_single, constant},
                                                   {is_list, pair},
                                                   {has_keys, keyed(key, single)},
                                                   {is_map, record<Eased<V>>(spec)}});
    result.info.noun = "changing";
    result.show = [show = single.show](const Eased<V>& value) {
        return show ? show(value.start) : std::string();
    };
    return result;
}

}  // namespace carom::pipeline::config
