#include "pipeline/job/exported_frame.h"

namespace carom::pipeline {

render::Film exported_frame(const render::Film& picture, const FilmSource& source,
                            std::int64_t frame) {
    render::Film film = picture;
    if (!source.layers(frame).front().reversed) {
        return film;
    }
    for (render::Channel& channel : film.aovs) {
        if (channel.name == "motion.X" || channel.name == "motion.Y") {
            for (float& value : channel.values) {
                value = 0 - value;  // 0 remains 0 instead of becoming -0
            }
        }
    }
    return film;
}

}  // namespace carom::pipeline
