#include "pipeline/job/scene_renderer.h"

#include <memory>
#include <optional>

#include "render/frame/frame.h"
#include "render/threads/thread_arena.h"

namespace carom::pipeline {
namespace {

class SceneRenderer {
  public:
    SceneRenderer(const Shot& shot, int threads, render::StructureFactory factory)
        : shot_(shot), arena_(threads), factory_(factory) {}

    render::Film render(const FrameInputs& inputs, const WorkContext& context,
                        render::FrameSums* sums) {
        return arena_.execute([&] {
            if (!scene_) {
                scene_.emplace(shot_.scene, shot_.render, factory_);
            }
            return render::render_frame(*scene_, inputs.tracks, inputs.frame, shot_.render, context,
                                        sums);
        });
    }

  private:
    const Shot& shot_;
    render::ThreadArena arena_;
    render::StructureFactory factory_;
    std::optional<render::PreparedScene> scene_;
};

}  // namespace

RenderFunction make_scene_renderer(const Shot& shot, int threads,
                                   render::StructureFactory factory) {
    const auto renderer = std::make_shared<SceneRenderer>(shot, threads, factory);
    return [renderer](const FrameInputs& inputs, const WorkContext& context,
                      render::FrameSums* sums) { return renderer->render(inputs, context, sums); };
}

}  // namespace carom::pipeline
