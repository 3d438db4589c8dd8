#include "pipeline/job/stored_tier.h"

#include <algorithm>

#include "pipeline/job/film_plan.h"
#include "pipeline/job/job_frames.h"
#include "render/acceleration/vector_tier.h"

namespace carom::pipeline {

std::string stored_tier(const Shot& shot, const sim::Bake& bake, const FilmJobOptions& options,
                        const std::stop_token& stop) {
    const FrameStore store(frames_folder(options));
    const std::vector<std::int64_t> frames = job_frames(shot, options);
    const auto missing = [&](const std::string& tier) {
        const FilmPlan plan = plan_film(FilmSource(shot, bake.timeline, tier), frames, stop);
        return std::ranges::count_if(plan.pictures, [&](const FilmPlan::Picture& picture) {
            return !store.contains(picture.key);
        });
    };
    std::string best(render::simd_tier());
    auto least = missing(best);
    for (const std::string_view option : render::kTierOptions) {
        const std::string tier(render::tier_named(option));
        if (least == 0) {
            break;
        }
        const auto count = missing(tier);
        if (count < least) {
            least = count;
            best = tier;
        }
    }
    return best;
}

}  // namespace carom::pipeline
