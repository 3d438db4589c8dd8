#include "pipeline/report/report_text.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include <fmt/core.h>

#include "pipeline/report/impact_series.h"

namespace carom::pipeline {

namespace {

constexpr double kDegrees = 57.295779513082321;

/// The number of characters of UTF-8 text.
std::size_t columns_of(std::string_view text) {
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
        return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
    }));
}

/// The text, left-aligned in `width` columns. A longer one is followed by a new line of that many
/// blanks after `indent` others.
std::string cell(const std::string& text, int width, int indent = 0) {
    const auto columns = static_cast<int>(columns_of(text));
    return columns <= width
               ? text + std::string(static_cast<std::size_t>(width - columns), ' ')
               : text + "\n" + std::string(static_cast<std::size_t>(indent + width), ' ');
}

/// A number with as many decimals as fit, right-aligned.
std::string number(double value, int width, int decimals) {
    std::string text;
    do {
        text = fmt::format("{:.{}f}", value, decimals);
        if (text.front() == '-' && text.find_first_not_of("-0.") == std::string::npos) {
            text.erase(0, 1);  // no -0.000
        }
    } while (static_cast<int>(text.size()) > width && --decimals >= 0);
    return " " + fmt::format("{:>{}}", text, width);
}

std::string blanks(int width) {
    return std::string(static_cast<std::size_t>(width), ' ');
}

std::string place_text(const Vec3& p) {
    return number(p.x, 6, 3) + number(p.y, 6, 3) + number(p.z, 5, 3);
}

std::string without_trailing_blanks(std::string line) {
    line.erase(line.find_last_not_of(' ') + 1);
    return line + "\n";
}

/// At a transition between laws of motion the speed does not change, so it is given once. The spin
/// is the one after the event.
std::string motion_text(const std::optional<SpeedChange>& speeds, bool is_jump) {
    if (!speeds) {
        return blanks(18);
    }
    return (is_jump ? number(speeds->before, 5, 3) : blanks(6)) + number(speeds->after, 5, 3) +
           number(speeds->spin_after.length(), 5, 1);
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

const char* relation_of(sim::EventKind kind) {
    return kind == sim::EventKind::placed ? " on " : " - ";
}

std::string who_text(const sim::Event& event) {
    return event.b.empty() ? event.a : event.a + relation_of(event.kind) + event.b;
}

/// The table of events: a line each, and a second one for the other object of an impact.
class EventTable {
  public:
    EventTable(const ShotReport& report, int columns) {
        constexpr int kNumbers = 45;
        constexpr int kKind = 8;
        for (const ReportedEvent& row : report.events) {
            time_ = std::max(time_, static_cast<int>(fmt::format("{:.5f}", row.event.time).size()));
        }
        before_who_ = time_ + 1 + kKind + 1;
        for (const ReportedEvent& row : report.events) {
            who_ = std::max(who_, static_cast<int>(columns_of(who_text(row.event))));
        }
        who_ = std::min(who_, columns - before_who_ - kNumbers);
    }

    [[nodiscard]] std::string heading() const {
        return without_trailing_blanks(blanks(before_who_ + who_) + "before after  spin") +
               fmt::format("{:>{}} event    {:{}}", "time", time_, "who", who_) +
               "   m/s   m/s rad/s    N s    x m    y m   z m\n";
    }

    [[nodiscard]] std::string lines(const ReportedEvent& row) const {
        const sim::Event& event = row.event;
        const bool has_impulse =
            event.kind == sim::EventKind::impact || event.kind == sim::EventKind::strike;
        std::string who = who_text(event);
        if (row.b && static_cast<int>(columns_of(who)) > who_) {
            who = event.a + " -";  // the other one is named in the second line
        }
        const bool has_numbers = row.a || has_impulse;
        std::string text = without_trailing_blanks(
            start(event) + (has_numbers ? cell(who, who_, before_who_) : who) +
            motion_text(row.a, is_jump(event.kind)) +
            (has_impulse ? number(event.normal_impulse, 6, 4) : blanks(7)) +
            place_text(event.place));
        if (row.b) {
            text += without_trailing_blanks(
                blanks(before_who_) + cell(event.b, who_, before_who_) + motion_text(row.b, true) +
                (row.cut ? fmt::format("  cut {:.1f} deg", *row.cut * kDegrees) : ""));
        }
        return text;
    }

    [[nodiscard]] std::string lines(const ReportedEvent& first, const ImpactSeries& series) const {
        return without_trailing_blanks(
            start(first.event) + cell(who_text(first.event), who_, before_who_) +
            fmt::format(" {} times until {:.3f} s, up to{} N s", series.count, series.last_time,
                        number(series.strongest, 6, 4)));
    }

  private:
    [[nodiscard]] std::string start(const sim::Event& event) const {
        return fmt::format("{:{}.5f} {:<8} ", event.time, time_, to_string(event.kind));
    }

    int time_ = 7;
    int before_who_ = 0;  // columns
    int who_ = 3;
};

std::string events_table(const ShotReport& report, const ReportLook& look) {
    const EventTable table(report, look.columns);
    const std::vector<ImpactSeries> series =
        look.every_impact ? std::vector<ImpactSeries>{} : find_impact_series(report.events);
    std::vector<const ImpactSeries*> series_of(report.events.size());
    for (const ImpactSeries& one : series) {
        for (const std::size_t event : one.events) {
            series_of[event] = &one;
        }
    }
    std::string text = table.heading();
    for (std::size_t i = 0; i < report.events.size(); ++i) {
        if (series_of[i] == nullptr) {
            text += table.lines(report.events[i]);
        } else if (series_of[i]->events.front() == i) {
            text += table.lines(report.events[i], *series_of[i]);
        }
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
            return "moving at " + (object.speed < 0.001 ? fmt::format("{:.1e} m/s", object.speed)
                                                        : fmt::format("{:.3f} m/s", object.speed));
        case Fate::potted:
            return fmt::format("potted at {:.3f} s: ", object.fate_time) + object.pocket;
        case Fate::off_table:
            return fmt::format("off the table at {:.3f} s", object.fate_time);
        case Fate::removed:
            return fmt::format("taken off at {:.3f} s", object.fate_time);
    }
    return {};
}

/// How the objects moved, and where they ended.
std::string objects_tables(const ShotReport& report, int columns) {
    constexpr int kNumbers = 42;
    constexpr int kPlace = 22;
    int name = 10;
    int fate = 0;
    for (const ReportedObject& object : report.objects) {
        name = std::max(name, static_cast<int>(columns_of(object.name)));
        fate = std::max(fate, static_cast<int>(columns_of(fate_text(object))));
    }
    name = std::min(name, columns - std::max(kNumbers, kPlace + fate));
    name = std::max(name, 10);
    std::string text = cell("object", name) + "  path m top m/s     at s rise mm cushions\n";
    std::string ends = cell("at the end", name) + "    x m    y m   z m\n";
    for (const ReportedObject& object : report.objects) {
        text += cell(object.name, name) + number(object.path, 7, 3) +
                number(object.top_speed, 7, 3) + number(object.top_time, 8, 3) +
                number(1000 * object.rise, 7, 1) + fmt::format(" {:8}\n", object.cushions);
        ends +=
            cell(object.name, name) + place_text(object.place) + "  " + fate_text(object) + "\n";
    }
    return text + "\n" + ends;
}

std::string energy_table(const ShotReport& report, int columns) {
    constexpr int kNumbers = 46;
    int when = 6;
    for (const ReportedEnergy& mark : report.energy) {
        when = std::max(when, static_cast<int>(columns_of(mark.when)));
    }
    when = std::min(when, columns - kNumbers);
    std::string text = cell("energy", when) + "      time   kinetic J potential J     total J\n";
    for (const ReportedEnergy& mark : report.energy) {
        const sim::EnergySample& sample = mark.sample;
        text += cell(mark.when, when) + number(sample.time, 9, 5) + number(sample.kinetic, 11, 6) +
                number(sample.potential, 11, 6) + number(sample.total(), 11, 6) + "\n";
    }
    const bool is_driven =
        std::ranges::any_of(report.energy, [](const auto& mark) { return mark.sample.work != 0; });
    if (is_driven) {
        text += fmt::format("objects moved by keys have put in {:.6f} J\n",
                            report.energy.back().sample.work);
    }
    const std::string apart = is_driven ? "apart from that " : "";
    if (report.largest_energy_rise == 0) {
        return text + apart + "it never rises between force events\n";
    }
    return text + apart +
           fmt::format("the largest rise between force events is {:.1e} of the {}\n",
                       report.largest_energy_rise,
                       is_driven ? "kinetic energy or of that work" : "kinetic energy");
}

std::string moments_table(const ShotReport& report) {
    std::string text = "     time moment\n";
    for (const ReportedMoment& moment : report.moments) {
        text +=
            (moment.time ? number(*moment.time, 8, 5) : "    never") + " " + moment.key_path + "\n";
    }
    return text;
}

std::string first_line(const ShotReport& report) {
    const std::size_t shown = report.events.size();
    return fmt::format("{:.3f} s to {:.3f} s, {} objects, ", report.start_time, report.end_time,
                       report.all_objects) +
           (shown == report.all_events ? "" : fmt::format("{} of ", shown)) +
           fmt::format("{} events\n", report.all_events);
}

}  // namespace

std::string report_text(const ShotReport& report, const ReportLook& look) {
    const ReportParts& parts = look.parts;
    std::string text = first_line(report);
    if (parts.events) {
        text += "\n" + events_table(report, look);
    }
    if (parts.objects) {
        text += "\n" + objects_tables(report, look.columns);
    }
    if (parts.energy) {
        text += "\n" + energy_table(report, look.columns);
    }
    if (parts.moments && !report.moments.empty()) {
        text += "\n" + moments_table(report);
    }
    return text;
}

}  // namespace carom::pipeline
