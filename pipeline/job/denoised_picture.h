// Pictures without noise, made of stored ones.
#pragma once

#include "core/progress.h"
#include "pipeline/shot/shot.h"
#include "render/film/film.h"

namespace carom::pipeline {

/// Whether the shot's pictures are denoised (output.denoise).
[[nodiscard]] bool denoises(const Shot& shot);

/// `noisy` with as little noise as the shot asks for, on threads of the caller's arena. `noisy`:
/// a picture as the store returns it, with the channels for the denoiser. The result is rounded as
/// if it had been stored; its bytes depend on `noisy` and the strength alone. Throws Error,
/// Stopped.
[[nodiscard]] render::Film denoised_picture(const render::Film& noisy, const Shot& shot,
                                            const WorkContext& context = {});

}  // namespace carom::pipeline
