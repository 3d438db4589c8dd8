// An object that is moved by keys.
#include "pipeline/config/sections/sections.h"
#include "pipeline/config/show_quantity.h"

namespace carom::pipeline::config {

namespace {

constexpr double kLongest = 3600;      // s
constexpr double kFarthest = 1e5;      // m
constexpr double kFastest = 1e5;       // m/s
constexpr double kShortestGap = 1e-6;  // s; what is nearer would be a jump

const MapSpec<MotionKey>& motion_key_spec() {
    static const MapSpec<MotionKey> spec = [] {
        MapSpec<MotionKey> s(
            "motion key",
            "Where an object is at a scene time. What is left out is as in the key "
            "before.");
        s.key("at", &MotionKey::time, time(between(0, kLongest)), "scene time").required();
        s.key("position", &MotionKey::position,
              vector3(Dimension::length, between(-kFarthest, kFarthest)),
              "of its origin, world axes; in the first key else the object's `at`");
        s.key("rotate", &MotionKey::rotate, rotation(),
              "like the object's, which it is in the first key unless said; reached by the shorter "
              "way round");
        s.key("turn", &MotionKey::turn, rotation_vector(),
              "instead of `rotate`: how far and which way it turns from the key before, more than "
              "half a round too");
        s.key(
            "velocity", &MotionKey::velocity,
            vector3(Dimension::speed, between(-kFastest, kFastest)),
            "with which it passes, of a smooth motion; else the mean velocity from the key before "
            "to the key after, and none in the first and the last key and beside a pause");
        s.at_most_one_of({"rotate", "turn"});
        return s;
    }();
    return spec;
}

void check_order(Reader& reader, const Node& node, KeyedMotion& motion) {
    const Entry* list = node.find("keys");
    if (list == nullptr || motion.keys.size() != list->value.items.size()) {
        return;  // something was wrong with them
    }
    if (const Entry* turn = list->value.items.front().find("turn")) {
        reader.error(turn->key_place,
                     "'turn' is from the key before, which the first has not: give 'rotate'");
    }
    bool is_ordered = true;
    for (std::size_t i = 0; i < motion.keys.size(); ++i) {
        const Node& item = list->value.items[i];
        const Entry* at = item.find("at");
        const double earliest = i > 0 ? motion.keys[i - 1].time + kShortestGap : 0;
        is_ordered = is_ordered && motion.keys[i].time >= earliest;  // not if one could not be read
        if (at != nullptr && motion.keys[i].time < earliest) {
            reader.error(at->value.place, "'at' must be later than that of the key before, " +
                                              show(motion.keys[i - 1].time, Dimension::time) +
                                              ", by a microsecond or more");
        }
        const Entry* velocity = item.find("velocity");
        if (velocity != nullptr && motion.is_linear) {
            reader.error(velocity->key_place,
                         "'velocity' is for smooth motions; with 'easing: linear' the keys say it");
        }
    }
    if (!is_ordered) {
        motion.keys.clear();
    }
}

}  // namespace

const MapSpec<KeyedMotion>& motion_spec() {
    static const MapSpec<KeyedMotion> spec = [] {
        MapSpec<KeyedMotion> s(
            "motion",
            "Where an object goes that is not moved by physics. It stands before "
            "the first key and after the last.");
        s.key("keys", &KeyedMotion::keys, list_of(record(motion_key_spec()), 2, 1000),
              "in order of time")
            .required();
        s.key("easing", &KeyedMotion::is_linear,
              choice<bool>({{"smooth", false}, {"linear", true}}),
              "`smooth`: starts and stops gently and passes the keys between without a jolt; "
              "`linear`: straight and at constant speed from key to key");
        s.check(check_order);
        return s;
    }();
    return spec;
}

}  // namespace carom::pipeline::config
