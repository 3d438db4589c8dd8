// The parts of a report that are wanted.
#pragma once

#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/report/shot_report.h"

namespace carom::pipeline {

/// The parts besides the events. A report without them still has its first line.
struct ReportParts {
    bool events = true;
    bool objects = true;
    bool energy = true;
    bool energy_over_time = true;  // all samples, in JSON
    bool moments = true;
};

/// Which events and which parts are wanted.
struct ReportFilter {
    std::vector<std::string> only{};     // words of report_words(); empty: everything
    std::vector<std::string> without{};  // words, which have precedence
    std::vector<std::string> objects{};  // names, of which an event has one; empty: any
    double from = -std::numeric_limits<double>::infinity();  // scene time, s
    double to = std::numeric_limits<double>::infinity();
    double min_impulse = 0;  // N s, of impacts and strikes

    bool operator==(const ReportFilter&) const = default;
};

/// The words that name events and parts, in the order of the help: "impacts", "pots", "energy" ...
/// Each kind of event has its own name, too: "rolling".
[[nodiscard]] std::vector<std::string> report_words();

/// Removes the events and objects that are not wanted. Returns the parts to show.
ReportParts apply(const ReportFilter& filter, ShotReport& report);

}  // namespace carom::pipeline
