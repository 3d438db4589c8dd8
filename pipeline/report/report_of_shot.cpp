#include "pipeline/report/report_of_shot.h"

#include "pipeline/shot/cue_stick.h"

namespace carom::pipeline {

ShotReport report_of_shot(const Shot& shot, const sim::Timeline& timeline) {
    ShotReport report = report_of(timeline);
    std::erase_if(report.objects,
                  [](const ReportedObject& object) { return object.name == kStickTrack; });
    for (const ShotMoment& moment : shot.moments) {
        report.moments.push_back({moment.key_path, moment.time.value_or(0)});
    }
    return report;
}

}  // namespace carom::pipeline
