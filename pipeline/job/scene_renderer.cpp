#include "pipeline/job/scene_renderer.h"

#include <memory>
#include <optional>
#include <utility>

#include "pipeline/job/far_light.h"
#include "render/frame/frame.h"
#include "render/threads/thread_arena.h"

namespace carom::pipeline {
namespace {

class SceneRenderer {
  public:
    SceneRenderer(const Shot& shot, int threads, render::NamedStructures structures,
                  std::shared_ptr<const FrameStore> store)
        : shot_(shot), arena_(threads), structures_(structures), store_(std::move(store)) {}

    render::Film render(const FrameInputs& inputs, const WorkContext& context,
                        render::FrameSums* sums) {
        return arena_.execute([&] {
            const double prepared = scene_ ? 0 : prepare(context);
            return render::render_frame(*scene_, inputs.tracks, inputs.frame, shot_.render,
                                        part_of(context, prepared, 1), sums);
        });
    }

  private:
    /// The progress of a part of the work.
    static WorkContext part_of(const WorkContext& context, double from, double to) {
        WorkContext part{{}, context.stop};
        if (context.progress) {
            part.progress = [progress = context.progress, from, to](double fraction) {
                progress(from + fraction * (to - from));
            };
        }
        return part;
    }
    /// Returns the fraction of the first picture's progress that this was.
    double prepare(const WorkContext& context) {
        constexpr double kOfFarLight = 0.9;
        const bool has_far =
            shot_.scene.far && shot_.render.integrator == render::IntegratorKind::path;
        auto light = has_far ? known_far_light(shot_.scene, store_.get()) : nullptr;
        const bool is_missing = has_far && light == nullptr;
        if (is_missing) {
            light = far_light(shot_.scene, store_.get(), part_of(context, 0, kOfFarLight));
        }
        scene_.emplace(shot_.scene, shot_.render,
                       render::structure_maker(structures_, shot_.render.acceleration),
                       std::move(light));
        return is_missing ? kOfFarLight : 0;
    }

    const Shot& shot_;
    render::ThreadArena arena_;
    render::NamedStructures structures_;
    std::shared_ptr<const FrameStore> store_;
    std::optional<render::PreparedScene> scene_;
};

}  // namespace

RenderFunction make_scene_renderer(const Shot& shot, int threads,
                                   render::NamedStructures structures,
                                   std::shared_ptr<const FrameStore> store) {
    const auto renderer =
        std::make_shared<SceneRenderer>(shot, threads, structures, std::move(store));
    return [renderer](const FrameInputs& inputs, const WorkContext& context,
                      render::FrameSums* sums) { return renderer->render(inputs, context, sums); };
}

}  // namespace carom::pipeline
