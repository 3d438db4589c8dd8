#include "pipeline/picture/annotation_painter.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "pipeline/picture/build_shapes.h"
#include "pipeline/picture/canvas.h"
#include "pipeline/picture/obstacles.h"
#include "pipeline/picture/picture_items.h"
#include "pipeline/picture/placed_shapes.h"
#include "pipeline/picture/scene_layer.h"

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

double opacity_at(const Annotation& annotation, double scene_time, double video_time) {
    const auto since = [&](const AnnotationTime& time) {
        return (time.is_moment || is_in_scene(annotation) ? scene_time : video_time) - time.seconds;
    };
    const double shown = annotation.from ? since(*annotation.from) : 0;
    const double left = annotation.to ? -since(*annotation.to) : 0;
    if (shown < 0 || left < 0) {
        return 0;
    }
    double opacity = annotation.opacity;
    if (annotation.fade > 0 && annotation.from) {
        opacity *= std::min(1.0, shown / annotation.fade);
    }
    if (annotation.fade > 0 && annotation.to) {
        opacity *= std::min(1.0, left / annotation.fade);
    }
    return opacity;
}

class AnnotationPainter::Painter {
  public:
    Painter(const Shot& shot, const sim::Timeline& timeline)
        : shot_(shot), timeline_(timeline), items_(shot, timeline, fonts_) {
        paths_ = static_cast<std::size_t>(
            std::ranges::count_if(shot.annotations, [](const Annotation& annotation) {
                return std::holds_alternative<PathAnnotation>(annotation.kind);
            }));
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
        SceneMoment moment{shot_, timeline_, view, moment_of(frame), time, 0, paths_};
        for (const Annotation& annotation : shot_.annotations) {
            const bool is_path = std::holds_alternative<PathAnnotation>(annotation.kind);
            const double opacity =
                is_in_scene(annotation)
                    ? frame.weight * opacity_at(annotation, time, frame.video_time)
                    : 0;
            if (opacity > 0) {
                SceneShapes shown = shapes_of(annotation, moment);
                if (annotation.lit > 0) {  // the rest is in the scene
                    std::erase_if(shown, [](const SceneShape& shape) {
                        return !std::holds_alternative<SceneText>(shape);
                    });
                }
                const std::vector<PlacedShape> shapes = placed_shapes(shown, view, fonts_);
                draw_shapes(shapes, view, opacity, time, obstacles);
            }
            moment.path_index += is_path ? 1 : 0;
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
        for (const Annotation& annotation : shot_.annotations) {
            if (is_in_scene(annotation)) {
                continue;
            }
            const double opacity = opacity_at(annotation, frame.scene_time, frame.video_time);
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
    std::size_t paths_ = 0;
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
