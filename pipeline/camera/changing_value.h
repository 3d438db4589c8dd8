// The values of a rig that change during its interval of the film.
#pragma once

#include <cstddef>
#include <vector>

#include "pipeline/camera/camera_rig.h"
#include "pipeline/camera/easing.h"
#include "pipeline/camera/progress.h"

namespace carom::pipeline {

/// The interval of video time of the rig's whole path (CameraRig::written).
[[nodiscard]] FilmInterval written_interval(const CameraRig& rig);

/// The time of the film in that interval at a progress along the path, s; in the film as it was
/// written this is the video time.
[[nodiscard]] double written_time(const CameraRig& rig, Progress progress);

/// The progress along the rig's path at a time of that interval, rounded once from the exact
/// fraction, as that of a frame is.
[[nodiscard]] double progress_of(const CameraRig& rig, const Rational& video_time);

/// The two values between which a changing value is, and how far it has changed, eased.
template <class T>
struct Change {
    const T& from;
    const T& to;
    Progress progress;
};

/// The references are into `value`.
template <class T>
[[nodiscard]] Change<T> change_at(const Eased<T>& value, const CameraRig& rig, Progress progress) {
    const std::vector<ValueKey<T>>& keys = value.keys;
    if (keys.empty()) {
        return {value.start, value.end, ease(progress, value.easing)};
    }
    double before = 0;
    for (std::size_t next = 0; next < keys.size(); ++next) {
        const double after = progress_of(rig, keys[next].video_time);
        if (progress.done < after) {
            if (next == 0) {
                return {keys.front().value, keys.front().value, {0, 1}};
            }
            const double length = after - before;
            const Progress between{(progress.done - before) / length,
                                   (after - progress.done) / length};
            return {keys[next - 1].value, keys[next].value, ease(between, value.easing)};
        }
        before = after;
    }
    return {keys.back().value, keys.back().value, {0, 1}};
}

/// For numbers and vectors.
template <class T>
[[nodiscard]] T value_at(const Eased<T>& value, const CameraRig& rig, Progress progress) {
    const Change<T> change = change_at(value, rig, progress);
    return mix(change.from, change.to, change.progress);
}

}  // namespace carom::pipeline
