#include "pipeline/job/exported_frame.h"

#include "pipeline/camera/frame_plan.h"

namespace carom::pipeline {

render::Film exported_frame(const render::Film& picture, const FilmSource& source,
                            std::int64_t frame) {
    render::Film film = picture;
    const Shot& shot = source.shot();
    if (!plan_frame(frame, shot.cameras, shot.timing, source.timeline()).reversed) {
        return film;
    }
    for (render::Channel& channel : film.aovs) {
        if (channel.name == "motion.X" || channel.name == "motion.Y") {
            for (float& value : channel.values) {
                value = 0 - value;  // and 0 stays 0
            }
        }
    }
    return film;
}

}  // namespace carom::pipeline
