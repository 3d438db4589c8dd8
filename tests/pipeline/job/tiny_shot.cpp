#include "tests/pipeline/job/tiny_shot.h"

namespace carom::testing {

pipeline::Shot tiny_shot() {
    pipeline::Shot shot;
    shot.name = "tiny";
    shot.scene.materials = {{"white", {}}, {"green", {}}};
    shot.scene.materials[1].surface.base = Vec3(0.02, 0.2, 0.1);
    shot.scene.objects.resize(2);
    shot.scene.objects[0] = {"cloth", render::PlaneShape{}, {}, "", "green"};
    shot.scene.objects[1] = {"ball", render::SphereShape{0.03}, {}, "cue", "white"};
    shot.scene.lights = {{"sky", render::EnvironmentLight{}}};
    shot.render.width = 32;
    shot.render.height = 18;
    shot.render.samples = 2;
    shot.render.max_bounces = 1;
    pipeline::CameraRig rig;
    rig.name = "still";
    rig.video_end = {1, 2};
    rig.time_map = {0, {1, 2}};
    rig.position = pipeline::BezierPath{{{{0.2, -0.8, 0.3}, "", 0}}, false};
    rig.target = pipeline::BezierPath{{{{0.2, 0, 0}, "", 0}}, false};
    shot.cameras = {rig};
    shot.output.codec = pipeline::Codec::ffv1;
    return shot;
}

sim::Timeline tiny_timeline() {
    sim::Key start, stop, end;
    start.position = {0, 0, 0.03};
    start.velocity_in = start.velocity_out = {1, 0, 0};
    stop.time = 0.31;
    stop.position = {stop.time, 0, 0.03};
    stop.velocity_in = {1, 0, 0};
    end.time = 1;
    end.position = stop.position;
    sim::Timeline timeline;
    timeline.end_time = 1;
    timeline.tracks.emplace_back("cue", std::vector{start, stop, end});
    return timeline;
}

render::Film fake_picture(const pipeline::Shot& shot, const pipeline::FrameInputs& inputs) {
    render::Film film;
    film.width = shot.render.width;
    film.height = shot.render.height;
    const auto low_bits = static_cast<float>(inputs.frame.seed % 1024) / 1024;
    for (int i = 0; i < film.width * film.height; ++i) {
        const float shade = static_cast<float>(i) / static_cast<float>(film.width * film.height);
        film.rgba.insert(film.rgba.end(), {low_bits, shade, low_bits * shade, 1});
    }
    film.statistics.camera_rays = 100;
    return film;
}

pipeline::FilmJobResult make_film_with(const pipeline::RenderFunction& render,
                                       const pipeline::Shot& shot, const sim::Timeline& timeline,
                                       pipeline::FilmJobOptions options,
                                       const pipeline::JobObserver& observer,
                                       const std::stop_token& stop) {
    options.renderer = render;
    return make_film(shot, {timeline, {}, {}, {}}, options, observer, stop);
}

render::Film make_frame_with(const pipeline::RenderFunction& render, const pipeline::Shot& shot,
                             const sim::Timeline& timeline, std::int64_t frame,
                             pipeline::FilmJobOptions options,
                             const pipeline::JobObserver& observer, const std::stop_token& stop) {
    options.renderer = render;
    return make_frame(shot, {timeline, {}, {}, {}}, frame, options, observer, stop);
}

pipeline::RenderFunction FakeRenderer::function() {
    return [this](const pipeline::FrameInputs& inputs, const WorkContext& context,
                  render::FrameSums*) {
        {
            const std::scoped_lock lock(mutex_);
            rendered_.push_back(inputs.frame.scene_open);
        }
        if (context.progress) {
            context.progress(0.5);
        }
        return fake_picture(shot_, inputs);
    };
}

std::vector<double> FakeRenderer::rendered() const {
    const std::scoped_lock lock(mutex_);
    return rendered_;
}

}  // namespace carom::testing
