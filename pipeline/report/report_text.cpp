#include "pipeline/report/report_text.h"

#include <algorithm>

#include <fmt/core.h>

namespace carom::pipeline {

namespace {

constexpr double kDegrees = 57.295779513082321;
constexpr int kWidestWho = 17;
constexpr int kWidestName = 14;

/// The text, left-aligned in `width` columns; a longer text is shortened.
std::string in_columns(std::string text, int width) {
    const auto columns = static_cast<std::size_t>(width);
    if (text.size() > columns) {
        text = text.substr(0, columns - 1) + "~";
    }
    text.resize(columns, ' ');
    return text;
}

/// Replaces values that would be printed as -0.000 by 0.
double without_negative_zero(double value, double unit) {
    return value > -0.5 * unit && value < 0.5 * unit ? 0 : value;
}

std::string place_text(const Vec3& p) {
    return fmt::format("{:6.3f} {:6.3f} {:6.3f}", without_negative_zero(p.x, 1e-3),
                       without_negative_zero(p.y, 1e-3), without_negative_zero(p.z, 1e-3));
}

/// At a transition between laws of motion the speed does not change, so it is given once. The spin
/// is the one after the event.
std::string motion_text(const std::optional<SpeedChange>& speeds, bool is_jump) {
    if (!speeds) {
        return std::string(20, ' ');
    }
    return (is_jump ? fmt::format("{:6.3f}", speeds->before) : std::string(6, ' ')) +
           fmt::format(" {:6.3f} {:6.1f}", speeds->after, speeds->spin_after.length());
}

bool is_jump(sim::EventKind kind) {
    switch (kind) {
        case sim::EventKind::impact:
        case sim::EventKind::impulse:
        case sim::EventKind::velocity:
        case sim::EventKind::strike:
        case sim::EventKind::placed:
        case sim::EventKind::removed:
            return true;
        default:
            return false;
    }
}

std::string who_text(const sim::Event& event) {
    const char* relation = event.kind == sim::EventKind::placed ? " on " : " - ";
    return event.b.empty() ? event.a : event.a + relation + event.b;
}

int width_of_who(const ShotReport& report) {
    std::size_t width = 3;
    for (const ReportedEvent& row : report.events) {
        width = std::max(width, who_text(row.event).size());
    }
    return std::min(static_cast<int>(width), kWidestWho);
}

std::string without_trailing_blanks(std::string line) {
    line.erase(line.find_last_not_of(' ') + 1);
    return line + "\n";
}

std::string events_table(const ShotReport& report) {
    const int who = width_of_who(report);
    const bool any_cut = std::any_of(report.events.begin(), report.events.end(),
                                     [](const ReportedEvent& e) { return e.cut.has_value(); });
    const std::string blank = in_columns("", who);
    std::string text = without_trailing_blanks("                    " + blank +
                                               "  first  m/s    spin second  m/s    spin " +
                                               (any_cut ? "  cut" : "     ") + " impulse");
    text +=
        without_trailing_blanks("     time event     " + in_columns("who", who) +
                                " before  after  rad/s before  after  rad/s " +
                                (any_cut ? "  deg" : "     ") + "     N s    x m    y m    z m");
    for (const ReportedEvent& row : report.events) {
        const sim::Event& event = row.event;
        const bool has_impulse =
            event.kind == sim::EventKind::impact || event.kind == sim::EventKind::strike;
        text += without_trailing_blanks(
            fmt::format("{:9.5f} ", event.time) +
            in_columns(std::string(to_string(event.kind)), 9) + " " +
            in_columns(who_text(event), who) + " " + motion_text(row.a, is_jump(event.kind)) + " " +
            motion_text(row.b, is_jump(event.kind)) + " " +
            (row.cut ? fmt::format("{:5.1f}", *row.cut * kDegrees) : std::string(5, ' ')) + " " +
            (has_impulse ? fmt::format("{:7.4f}", event.normal_impulse) : std::string(7, ' ')) +
            " " + place_text(event.place));
    }
    return text;
}

std::string fate_text(const ReportedObject& object) {
    switch (object.fate) {
        case Fate::rests:
            return fmt::format("at rest since {:.3f} s", object.fate_time);
        case Fate::spins:
            return fmt::format("spinning since {:.3f} s", object.fate_time);
        case Fate::moves:
            return fmt::format("moving at {:.3f} m/s", object.speed);
        case Fate::potted:
            return fmt::format("potted at {:.3f} s: ", object.fate_time) + object.pocket;
        case Fate::off_table:
            return fmt::format("off the table at {:.3f} s", object.fate_time);
        case Fate::removed:
            return fmt::format("taken off at {:.3f} s", object.fate_time);
    }
    return {};
}

std::string objects_table(const ShotReport& report) {
    std::size_t longest = 6;
    for (const ReportedObject& object : report.objects) {
        longest = std::max(longest, object.name.size());
    }
    const int name = std::min(static_cast<int>(longest), kWidestName);
    std::string text =
        in_columns("object", name) +
        "  path m top m/s     at s rise mm cushions    x m    y m    z m  at the end\n";
    for (const ReportedObject& object : report.objects) {
        text += in_columns(object.name, name) +
                fmt::format(" {:7.3f} {:7.3f} {:8.3f} {:7.1f} {:8} ", object.path, object.top_speed,
                            object.top_time, 1000 * object.rise, object.cushions) +
                place_text(object.place) + "  " + fate_text(object) + "\n";
    }
    return text;
}

std::string energy_table(const ShotReport& report) {
    std::string text =
        in_columns("energy", 30) + "      time   kinetic J potential J     total J\n";
    for (const ReportedEnergy& mark : report.energy) {
        const sim::EnergySample& sample = mark.sample;
        text += in_columns(mark.when, 30) +
                fmt::format(" {:9.5f} {:11.6f} {:11.6f} {:11.6f}\n", sample.time, sample.kinetic,
                            without_negative_zero(sample.potential, 1e-6),
                            without_negative_zero(sample.total(), 1e-6));
    }
    if (report.largest_energy_rise == 0) {
        return text + "it never rises between force events\n";
    }
    return text + fmt::format("largest rise between force events: {:.1e} of the kinetic energy\n",
                              report.largest_energy_rise);
}

std::string moments_table(const ShotReport& report) {
    std::string text = "\n     time moment\n";
    for (const ReportedMoment& moment : report.moments) {
        text += fmt::format("{:9.5f} ", moment.time) + moment.key_path + "\n";
    }
    return text;
}

}  // namespace

std::string report_text(const ShotReport& report) {
    return fmt::format("{:.3f} s to {:.3f} s, {} objects, {} events\n\n", report.start_time,
                       report.end_time, report.objects.size(), report.events.size()) +
           events_table(report) + "\n" + objects_table(report) + "\n" + energy_table(report) +
           (report.moments.empty() ? "" : moments_table(report));
}

}  // namespace carom::pipeline
