#include "pipeline/picture/annotation_painter.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "pipeline/picture/canvas.h"
#include "pipeline/picture/obstacles.h"
#include "pipeline/picture/picture_items.h"
#include "pipeline/picture/placed_shapes.h"
#include "pipeline/picture/scene_layer.h"
#include "pipeline/picture/shown_annotations.h"

namespace carom::pipeline {
namespace {

// Parts of the picture that are drawn at once, so that the memory for samples stays small.
constexpr int kRowsAtOnce = 32;
constexpr int kColumnsAtOnce = 2048;

/// Of the middle of the exposure.
double middle_of(const PlannedFrame& frame) {
    return 0.5 * (frame.scene_open + frame.scene_close);
}

}  // namespace

class AnnotationPainter::Painter {
  public:
    Painter(const Shot& shot, const sim::Timeline& timeline)
        : shot_(shot), timeline_(timeline), items_(shot, timeline, fonts_) {
        for (const Annotation& annotation : shot.annotations) {
            times_.push_back(shown_times(annotation, shot.cameras));
        }
    }

    void prepare() {
        for (const Annotation& annotation : shot_.annotations) {
            (void)fonts_.of(annotation.font);
            items_.prepare(annotation);
        }
    }

    DrawnPicture draw(std::span<const PlannedFrame> layers, int width, int height,
                      DrawnAnnotations which) {
        canvas_.reset();
        width_ = width;
        height_ = height;
        for (const PlannedFrame& layer : layers) {
            draw_scene(layer);
        }
        if (which == DrawnAnnotations::all) {
            draw_items(layers.front());
        }
        if (!canvas_) {
            return {};
        }
        const std::span<const std::uint32_t> pixels = std::as_const(*canvas_).pixels();
        return {width, height, {pixels.begin(), pixels.end()}};
    }

  private:
    Canvas& canvas() {
        if (!canvas_) {
            canvas_.emplace(width_, height_);
        }
        return *canvas_;
    }

    void draw_scene(const PlannedFrame& frame) {
        const double time = middle_of(frame);
        const Pinhole view(frame, width_, height_);
        std::optional<Obstacles> obstacles;
        for (const ShownAnnotation& shown :
             shown_annotations(shot_, timeline_, view, moment_of(frame), time)) {
            const std::vector<PlacedShape> shapes = placed_shapes(shown.shapes, view, fonts_);
            draw_shapes(shapes, view, frame.weight * shown.opacity, time, obstacles);
        }
    }

    void draw_shapes(std::span<const PlacedShape> shapes, const Pinhole& view, double opacity,
                     double time, std::optional<Obstacles>& obstacles) {
        const PixelBox box = box_of(shapes, view.size());
        if (box.is_empty()) {
            return;
        }
        if (!geometry_) {
            geometry_.emplace(obstacle_geometry(shot_.scene, shot_.render));
        }
        if (!obstacles) {
            obstacles.emplace(*geometry_, timeline_, time);
        }
        for (int top = box.top; top < box.bottom; top += kRowsAtOnce) {
            for (int left = box.left; left < box.right; left += kColumnsAtOnce) {
                const SceneLayer layer(shapes,
                                       {left, top, std::min(left + kColumnsAtOnce, box.right),
                                        std::min(top + kRowsAtOnce, box.bottom)});
                layer.compose(view, *obstacles, opacity, canvas());
            }
        }
    }

    void draw_items(const PlannedFrame& frame) {
        for (std::size_t i = 0; i < shot_.annotations.size(); ++i) {
            const Annotation& annotation = shot_.annotations[i];
            const double opacity =
                is_in_scene(annotation) ? 0 : opacity_at(annotation, times_[i], frame.video_time);
            if (opacity <= 0) {
                continue;
            }
            cairo_t* context = canvas().context();
            cairo_push_group(context);
            items_.draw(annotation, moment_of(frame), canvas());
            cairo_pop_group_to_source(context);
            cairo_paint_with_alpha(context, opacity);
        }
    }

    const Shot& shot_;
    const sim::Timeline& timeline_;
    Fonts fonts_;
    PictureItems items_;
    std::vector<ShownTimes> times_;  // of the shot's annotations
    std::optional<render::StaticGeometry> geometry_;
    std::optional<Canvas> canvas_;  // of the frame that is being drawn
    int width_ = 0, height_ = 0;
};

AnnotationPainter::AnnotationPainter(const Shot& shot, const sim::Timeline& timeline)
    : painter_(std::make_unique<Painter>(shot, timeline)) {}

AnnotationPainter::~AnnotationPainter() = default;

void AnnotationPainter::prepare() {
    painter_->prepare();
}

DrawnPicture AnnotationPainter::draw(std::span<const PlannedFrame> layers, int width, int height,
                                     DrawnAnnotations which) {
    return painter_->draw(layers, width, height, which);
}

}  // namespace carom::pipeline
