// Rendering as the job sees it.
#pragma once

#include <functional>

#include "core/progress.h"
#include "pipeline/shot/shot.h"
#include "pipeline/store/frame_inputs.h"
#include "render/acceleration/structure_factory.h"
#include "render/film/film.h"

namespace carom::pipeline {

/// From a frame's inputs to its picture; the same inputs give the same picture. A job asks for one
/// at a time.
using RenderFunction = std::function<render::Film(const FrameInputs&, const WorkContext&)>;

/// render_frame on `threads` threads (0: as many as there are processors). The scene is prepared
/// when the first picture is asked for. Refers to `shot`; `factory` as for PreparedScene.
[[nodiscard]] RenderFunction make_scene_renderer(const Shot& shot, int threads,
                                                 render::StructureFactory factory);

}  // namespace carom::pipeline
