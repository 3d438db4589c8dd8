#include "pipeline/report/report_of_shot.h"

#include "pipeline/shot/cue_stick.h"

namespace carom::pipeline {

ShotReport report_of_shot(const Shot& shot, const sim::Timeline& timeline) {
    ShotReport report = report_of(timeline);
    std::erase_if(report.objects,
                  [](const ReportedObject& object) { return object.name == kStickTrack; });
    report.all_objects = report.objects.size();
    for (const ShotMoment& moment : shot.moments) {
        report.moments.push_back({moment.key_path, moment.time});
    }
    return report;
}

}  // namespace carom::pipeline
