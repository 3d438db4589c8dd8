#include "pipeline/camera/easing.h"

namespace carom::pipeline {

Progress ease(Progress progress, Easing easing) {
    if (easing == Easing::linear) {
        return progress;
    }
    if (progress.done <= 0) {
        return {0, 1};
    }
    if (progress.left <= 0) {
        return {1, 0};
    }
    // The cubic Hermite step 3 u^2 - 2 u^3 = u^2 (1 + 2 (1 - u)), written alike from both ends.
    return {progress.done * progress.done * (1 + 2 * progress.left),
            progress.left * progress.left * (1 + 2 * progress.done)};
}

}  // namespace carom::pipeline
