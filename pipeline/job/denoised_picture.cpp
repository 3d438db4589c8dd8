#include "pipeline/job/denoised_picture.h"

#include <cstddef>

#include "render/film/image_file.h"
#include "render/frame/denoiser_planes.h"

namespace carom::pipeline {

bool denoises(const Shot& shot) {
    return shot.render.for_denoiser && shot.output.denoise.strength > 0;
}

render::Film denoised_picture(const render::Film& noisy, const Shot& shot,
                              const WorkContext& context) {
    render::Film film = render::denoised(noisy, context);
    const auto strength = static_cast<float>(shot.output.denoise.strength);
    if (strength < 1) {
        for (std::size_t i = 0; i < film.rgba.size(); ++i) {
            film.rgba[i] = strength * film.rgba[i] + (1 - strength) * noisy.rgba[i];
        }
    }
    return render::as_stored(std::move(film), {});
}

}  // namespace carom::pipeline
