#include "pipeline/report/impact_series.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

namespace carom::pipeline {

std::vector<ImpactSeries> find_impact_series(const std::vector<ReportedEvent>& events) {
    constexpr double kLongestGap = 0.1;  // s
    constexpr int kLeast = 4;
    std::vector<ImpactSeries> found;
    std::map<std::pair<std::string, std::string>, ImpactSeries> open;
    const auto close = [&found](ImpactSeries& series) {
        if (series.count >= kLeast) {
            found.push_back(std::move(series));
        }
        series = {};
    };
    for (std::size_t i = 0; i < events.size(); ++i) {
        const sim::Event& event = events[i].event;
        if (event.kind != sim::EventKind::impact) {
            continue;
        }
        ImpactSeries& series = open[std::minmax(event.a, event.b)];
        if (series.count > 0 && event.time - series.last_time > kLongestGap) {
            close(series);
        }
        series.events.push_back(i);
        ++series.count;
        series.last_time = event.time;
        series.strongest = std::max(series.strongest, event.normal_impulse);
    }
    for (auto& [pair, series] : open) {
        close(series);
    }
    return found;
}

}  // namespace carom::pipeline
