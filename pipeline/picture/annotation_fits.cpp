#include "pipeline/picture/annotation_fits.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "core/error.h"
#include "pipeline/camera/frame_plan.h"
#include "pipeline/camera/path_fit.h"
#include "pipeline/picture/picture_items.h"
#include "pipeline/picture/placed_shapes.h"
#include "pipeline/picture/shown_annotations.h"

namespace carom::pipeline {

namespace {

constexpr std::int64_t kMostFrames = 200;

void add(AnnotationFit& fit, std::int64_t frame, double scale) {
    if (scale < 1) {
        fit.scale = std::min(fit.scale, scale);
        extend(fit.smaller, frame);
    }
}

void add(AnnotationFit& fit, std::int64_t frame, const AnnotationBox& box, const Vec2& picture) {
    constexpr double kSeen = 0.5;  // pixels
    const Vec2 high = box.corner + box.size - picture;
    const std::array<double, 4> now{-box.corner.x, high.x, -box.corner.y, high.y};
    for (std::size_t edge = 0; edge < now.size(); ++edge) {
        if (now.at(edge) > kSeen) {
            fit.beyond.at(edge) = std::max(fit.beyond.at(edge), now.at(edge));
            extend(fit.outside, frame);
        }
    }
}

class FitFinder {
  public:
    FitFinder(const Shot& shot, const sim::Timeline& timeline)
        : shot_(shot),
          timeline_(timeline),
          picture_(shot.render.width, shot.render.height),
          items_(shot, timeline, fonts_),
          fits_(shot.annotations.size()) {
        for (const Annotation& annotation : shot.annotations) {
            times_.push_back(shown_times(annotation, shot.cameras));
        }
    }

    std::vector<AnnotationFit> run() {
        const std::vector<CameraRig> rigs = with_fitted_paths(shot_.cameras, timeline_);
        const std::int64_t frames = frame_count(rigs, shot_.timing);
        const std::int64_t step = std::max<std::int64_t>(1, frames / kMostFrames);
        for (std::int64_t number = 0; number < frames; number += step) {
            std::optional<PlannedFrame> frame;
            try {
                frame = plan_frame(number, rigs, shot_.timing, timeline_);
            } catch (const Error&) {  // no valid view, which has its own message
                continue;
            }
            check_picture(*frame);
            check_scene(*frame);
        }
        return std::move(fits_);
    }

  private:
    void check_picture(const PlannedFrame& frame) {
        const FrameMoment moment = moment_of(frame);
        for (std::size_t i = 0; i < shot_.annotations.size(); ++i) {
            const Annotation& annotation = shot_.annotations[i];
            if (is_in_scene(annotation) ||
                !(opacity_at(annotation, times_[i], frame.video_time) > 0)) {
                continue;
            }
            if (const auto box = items_.box_of(annotation, moment, picture_)) {
                add(fits_[i], frame.number, items_.scale_of(annotation, moment, picture_));
                add(fits_[i], frame.number, *box, picture_);
            }
        }
    }

    void check_scene(const PlannedFrame& frame) {
        const double time = 0.5 * (frame.scene_open + frame.scene_close);
        const Pinhole view(frame, shot_.render.width, shot_.render.height);
        for (const ShownAnnotation& shown :
             shown_annotations(shot_, timeline_, view, moment_of(frame), time)) {
            for (const SceneShape& shape : shown.shapes) {
                const auto* text = std::get_if<SceneText>(&shape);
                if (text != nullptr && view.depth(text->at) > Pinhole::kNearest) {
                    add(fits_[shown.index], frame.number, scale_on(*text, view, fonts_));
                }
            }
        }
    }

    const Shot& shot_;
    const sim::Timeline& timeline_;
    Vec2 picture_;
    Fonts fonts_;
    PictureItems items_;
    std::vector<ShownTimes> times_;  // of the shot's annotations
    std::vector<AnnotationFit> fits_;
};

}  // namespace

std::vector<AnnotationFit> annotation_fits(const Shot& shot, const sim::Timeline& timeline) {
    return FitFinder(shot, timeline).run();
}

}  // namespace carom::pipeline
