#include "pipeline/config/sections/keyed_values.h"

#include "core/text.h"
#include "pipeline/config/text.h"

namespace carom::pipeline::config {

namespace {

constexpr double kLongest = 3600;  // s

/// The list of keys in the map of a value; nullptr if there is none.
const Node* key_list(const Node& value) {
    const Entry* keys = value.find("keys");
    return keys != nullptr && keys->value.is_sequence() ? &keys->value : nullptr;
}

}  // namespace

ValueType<Rational> film_time() {
    return exact(Dimension::time, between(0, kLongest));
}

bool has_keys(const Node& node) {
    return node.is_map() && node.find("keys") != nullptr;
}

void check_key_order(Reader& reader, const Node& node, const std::vector<Rational>& times) {
    const Node* list = key_list(node);
    for (std::size_t i = 1; list != nullptr && i < times.size(); ++i) {
        if (!(times[i - 1] < times[i])) {
            reader.error(list->items[i].place, "the times of 'keys' must be in increasing order");
        }
    }
}

void warn_about_unreached_keys(Reader& reader, const Node& camera, const CameraRig& rig,
                               const std::string& key, const std::vector<Rational>& times) {
    const Entry* value = camera.find(key);
    const Node* list = value != nullptr ? key_list(value->value) : nullptr;
    if (list == nullptr || !(rig.video_start < rig.video_end)) {
        return;
    }
    for (std::size_t i = 0; i < times.size() && i < list->items.size(); ++i) {
        if (times[i] < rig.video_start || rig.video_end < times[i]) {
            reader.warning(
                list->items[i].place,
                "the key of " + quote(key) + " at " + seconds_text(times[i].to_double()) +
                    " is outside of the interval of the film of " + reader.label() + ", " +
                    seconds_text(rig.video_start.to_double()) + " to " +
                    seconds_text(rig.video_end.to_double()) + ", so its value is never reached");
        }
    }
}

}  // namespace carom::pipeline::config
