// The keys of an object's motion.
#include "pipeline/config/sections/sections.h"
#include "pipeline/config/show_quantity.h"

namespace carom::pipeline::config {

namespace {

constexpr double kLongest = 3600;      // s
constexpr double kFarthest = 1e5;      // m
constexpr double kFastest = 1e5;       // m/s
constexpr double kShortestGap = 1e-6;  // s, between two keys

const MapSpec<MotionKey>& motion_key_spec() {
    static const MapSpec<MotionKey> spec = [] {
        MapSpec<MotionKey> s("motion key",
                             "Position and orientation of an object at a scene time. The defaults "
                             "are the values of the previous key.");
        s.key("at", &MotionKey::time, time(between(0, kLongest)), "scene time").required();
        s.key("position", &MotionKey::position,
              vector3(Dimension::length, between(-kFarthest, kFarthest)),
              "position of the object's origin in world coordinates. The default of the first key "
              "is the object's `at`");
        s.key("rotate", &MotionKey::rotate, rotation(),
              "orientation, written like the object's `rotate`, which is the default of the first "
              "key. The object rotates to it through the smaller angle");
        s.key("turn", &MotionKey::turn, rotation_vector(),
              "instead of `rotate`: the rotation since the previous key, which may be more than "
              "half a revolution");
        s.key("velocity", &MotionKey::velocity,
              vector3(Dimension::speed, between(-kFastest, kFastest)),
              "velocity at the key, for a smooth motion. The default is the mean velocity from the "
              "previous key to the next one, and zero at the first and the last key and next to a "
              "pause");
        s.at_most_one_of({"rotate", "turn"});
        return s;
    }();
    return spec;
}

void check_order(Reader& reader, const Node& node, KeyedMotion& motion) {
    const Entry* list = node.find("keys");
    if (list == nullptr || motion.keys.size() != list->value.items.size()) {
        return;  // their problem was reported
    }
    if (const Entry* turn = list->value.items.front().find("turn")) {
        reader.error(
            turn->key_place,
            "'turn' is relative to the previous key, and the first key has none; use 'rotate'");
    }
    bool is_ordered = true;
    for (std::size_t i = 0; i < motion.keys.size(); ++i) {
        const Node& item = list->value.items[i];
        const Entry* at = item.find("at");
        const double earliest = i > 0 ? motion.keys[i - 1].time + kShortestGap : 0;
        is_ordered =
            is_ordered && motion.keys[i].time >= earliest;  // false if one could not be read
        if (at != nullptr && motion.keys[i].time < earliest) {
            reader.error(at->value.place,
                         "'at' must be at least a microsecond later than that of "
                         "the previous key, " +
                             show(motion.keys[i - 1].time, Dimension::time));
        }
        const Entry* velocity = item.find("velocity");
        if (velocity != nullptr && motion.is_linear) {
            reader.error(velocity->key_place,
                         "'velocity' is only for smooth motions; 'easing: linear' computes it from "
                         "the keys");
        }
    }
    if (!is_ordered) {
        motion.keys.clear();
    }
}

}  // namespace

const MapSpec<KeyedMotion>& motion_spec() {
    static const MapSpec<KeyedMotion> spec = [] {
        MapSpec<KeyedMotion> s("motion",
                               "The path of an object that keys move, not the simulation. The "
                               "object stands still before the first key and after the last.");
        s.key("keys", &KeyedMotion::keys, list_of(record(motion_key_spec()), 2, 1000),
              "keys in order of time")
            .required();
        s.key("easing", &KeyedMotion::is_linear,
              choice<bool>({{"smooth", false}, {"linear", true}}),
              "`smooth`: the object starts and stops gently and passes the keys with a continuous "
              "velocity; `linear`: it moves straight and at constant speed from key to key");
        s.check(check_order);
        return s;
    }();
    return spec;
}

}  // namespace carom::pipeline::config
