#include "sound/mix/heard.h"

#include <limits>
#include <optional>

#include "core/error.h"
#include "sound/mix/crossings.h"
#include "sound/mix/hearing.h"

namespace carom::sound {

void list_heard(const SoundScene& scene, const std::function<void(const HeardImpact&)>& sink,
                const WorkContext& context) {
    const Hearing hearing(scene);
    Crossings crossings(scene);
    const double length = static_cast<double>(scene.frames) / kSampleRate;
    while (const std::optional<Crossing> crossing = crossings.next_before(length)) {
        if (context.stop.stop_requested()) {
            throw Stopped();
        }
        if (const std::optional<Heard> heard = hearing.at(*crossing)) {
            sink(heard->row);
        }
        if (context.progress) {
            context.progress(crossing->film_time / length);
        }
    }
    if (context.progress) {
        context.progress(1);
    }
}

std::vector<HeardImpact> heard(const SoundScene& scene, const WorkContext& context) {
    std::vector<HeardImpact> rows;
    list_heard(
        scene, [&rows](const HeardImpact& row) { rows.push_back(row); }, context);
    return rows;
}

}  // namespace carom::sound
