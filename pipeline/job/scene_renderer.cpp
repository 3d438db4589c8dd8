#include "pipeline/job/scene_renderer.h"

#include <memory>
#include <optional>

#include "render/frame/frame.h"
#include "render/threads/thread_arena.h"

namespace carom::pipeline {
namespace {

class SceneRenderer {
  public:
    SceneRenderer(const Shot& shot, int threads, render::NamedStructures structures)
        : shot_(shot), arena_(threads), structures_(structures) {}

    render::Film render(const FrameInputs& inputs, const WorkContext& context,
                        render::FrameSums* sums) {
        return arena_.execute([&] {
            if (!scene_) {
                scene_.emplace(shot_.scene, shot_.render,
                               render::structure_maker(structures_, shot_.render.acceleration));
            }
            return render::render_frame(*scene_, inputs.tracks, inputs.frame, shot_.render, context,
                                        sums);
        });
    }

  private:
    const Shot& shot_;
    render::ThreadArena arena_;
    render::NamedStructures structures_;
    std::optional<render::PreparedScene> scene_;
};

}  // namespace

RenderFunction make_scene_renderer(const Shot& shot, int threads,
                                   render::NamedStructures structures) {
    const auto renderer = std::make_shared<SceneRenderer>(shot, threads, structures);
    return [renderer](const FrameInputs& inputs, const WorkContext& context,
                      render::FrameSums* sums) { return renderer->render(inputs, context, sums); };
}

}  // namespace carom::pipeline
