// The function with which a job renders pictures.
#pragma once

#include <functional>
#include <memory>

#include "core/progress.h"
#include "pipeline/shot/shot.h"
#include "pipeline/store/frame_inputs.h"
#include "pipeline/store/frame_store.h"
#include "render/acceleration/structure_maker.h"
#include "render/film/film.h"
#include "render/frame/frame_sums.h"

namespace carom::pipeline {

/// Renders the picture of a frame from its inputs. The same inputs give the same picture. If sums
/// are given, the picture goes on with them and keeps its samples there when it is stopped. A job
/// renders one picture at a time.
using RenderFunction =
    std::function<render::Film(const FrameInputs&, const WorkContext&, render::FrameSums*)>;

/// Calls render_frame on `threads` threads (0: one per processor). The scene is prepared for the
/// first picture, its far light with it, which is looked for in `store` and kept there. Refers to
/// `shot`; `structures` and `store` may be null.
[[nodiscard]] RenderFunction make_scene_renderer(const Shot& shot, int threads,
                                                 render::NamedStructures structures,
                                                 std::shared_ptr<const FrameStore> store = nullptr);

}  // namespace carom::pipeline
