#include "pipeline/cli/report_json.h"

#include <limits>
#include <vector>

#include "core/json_text.h"
#include "core/text.h"
#include "sim/timeline/event_fields.h"

namespace carom::cli {

namespace {

using pipeline::Fate;

/// A JSON array with one object per line.
std::string array(const std::vector<std::string>& objects) {
    return objects.empty() ? "[]" : "[\n" + join(objects, ",\n") + "]";
}

void add_place(JsonMembers& members, const Vec3& p) {
    members.add("x", p.x).add("y", p.y).add("z", p.z);
}

/// Adds speed and spin before and after the event: "a_speed_before" and so on for its first object.
void add_motion(JsonMembers& members, const std::string& which,
                const std::optional<pipeline::SpeedChange>& change) {
    if (change) {
        const Vec3& before = change->spin_before;
        const Vec3& after = change->spin_after;
        members.add(which + "_speed_before", change->before)
            .add(which + "_speed_after", change->after)
            .add(which + "_spin_before", {before.x, before.y, before.z})
            .add(which + "_spin_after", {after.x, after.y, after.z});
    }
}

std::string event_object(const pipeline::ReportedEvent& row) {
    const sim::Event& event = row.event;
    JsonMembers members;
    members.add("time", event.time).add("kind", to_string(event.kind)).add("a", event.a);
    if (event.end_time > event.time) {
        members.add("end_time", event.end_time);
    }
    if (!event.b.empty()) {
        members.add("b", event.b);
    }
    add_place(members, event.place);
    add_motion(members, "a", row.a);
    add_motion(members, "b", row.b);
    if (row.cut) {
        members.add("cut", *row.cut);
    }
    if (event.kind == sim::EventKind::impact) {
        members.add("normal", {event.normal.x, event.normal.y, event.normal.z})
            .add("normal_impulse", event.normal_impulse)
            .add("tangential_impulse", event.tangential_impulse);
    }
    if (event.kind == sim::EventKind::strike) {
        members.add("normal_impulse", event.normal_impulse);
    }
    if (event.vector != Vec3(0, 0, 0)) {
        members.add("vector", {event.vector.x, event.vector.y, event.vector.z});
    }
    if (row.heard_at) {
        members.add("heard_at", *row.heard_at);
    }
    return members.object();
}

const char* fate_name(Fate fate) {
    switch (fate) {
        case Fate::rests:
            return "rests";
        case Fate::spins:
            return "spins";
        case Fate::moves:
            return "moves";
        case Fate::potted:
            return "potted";
        case Fate::removed:
            return "removed";
        case Fate::off_table:
            break;
    }
    return "off_table";
}

std::string object_object(const pipeline::ReportedObject& object) {
    JsonMembers members;
    members.add("name", object.name)
        .add("path", object.path)
        .add("top_speed", object.top_speed)
        .add("top_time", object.top_time)
        .add("rise", object.rise)
        .add("cushions", object.cushions)
        .add("fate", fate_name(object.fate))
        .add("fate_time", object.fate_time);
    if (!object.pocket.empty()) {
        members.add("pocket", object.pocket);
    }
    members.add("speed", object.speed);
    add_place(members, object.place);
    return members.object();
}

JsonMembers energy_members(const sim::EnergySample& sample) {
    JsonMembers members;
    for_each_field(sample,
                   [&](const auto& field, double value) { members.add(field.name, value); });
    return members;
}

std::string energy_object(const pipeline::ReportedEnergy& mark) {
    JsonMembers members;
    if (!mark.when.empty()) {
        members.add("when", mark.when);
    }
    return members.add(energy_members(mark.sample)).object();
}

std::string sample_object(const sim::EnergySample& sample) {
    return energy_members(sample).object();
}

std::string moment_object(const pipeline::ReportedMoment& moment) {
    const double never = std::numeric_limits<double>::quiet_NaN();  // null
    return JsonMembers()
        .add("key", moment.key_path)
        .add("time", moment.time.value_or(never))
        .object();
}

template <typename Item, typename Write>
std::string array_of(const std::vector<Item>& items, Write write) {
    std::vector<std::string> objects;
    objects.reserve(items.size());
    for (const Item& item : items) {
        objects.push_back(write(item));
    }
    return array(objects);
}

}  // namespace

std::string report_json(const pipeline::ShotReport& report, const pipeline::ReportParts& parts) {
    std::string text = "{" + JsonMembers()
                                 .add("start_time", report.start_time)
                                 .add("end_time", report.end_time)
                                 .add("largest_energy_rise", report.largest_energy_rise)
                                 .text();
    const auto add = [&text](bool is_shown, const char* name, const auto& items, auto write) {
        text += is_shown ? ",\n\"" + std::string(name) + "\":" + array_of(items, write) : "";
    };
    add(parts.events, "events", report.events, event_object);
    add(parts.objects, "objects", report.objects, object_object);
    add(parts.moments, "moments", report.moments, moment_object);
    add(parts.energy, "energy", report.energy, energy_object);
    add(parts.energy_over_time, "energy_over_time", report.energy_samples, sample_object);
    return text + "}\n";
}

}  // namespace carom::cli
