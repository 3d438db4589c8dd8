#include "pipeline/camera/changing_value.h"

#include "pipeline/camera/wide_rational.h"

namespace carom::pipeline {

FilmInterval written_interval(const CameraRig& rig) {
    return rig.written.value_or(FilmInterval{rig.video_start, rig.video_end});
}

double written_time(const CameraRig& rig, Progress progress) {
    const FilmInterval interval = written_interval(rig);
    return interval.start.to_double() * progress.left + interval.end.to_double() * progress.done;
}

double progress_of(const CameraRig& rig, const Rational& video_time) {
    const FilmInterval interval = written_interval(rig);
    const WideRational start(interval.start);
    return ((WideRational(video_time) - start) / (WideRational(interval.end) - start)).to_double();
}

}  // namespace carom::pipeline
