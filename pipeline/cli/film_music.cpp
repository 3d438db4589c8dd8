#include "pipeline/cli/film_music.h"

#include "core/assert.h"
#include "core/error.h"

namespace carom::cli {

sound::AddedSound film_music(const pipeline::OutputSettings& output, std::int64_t film_samples,
                             const CommandContext& context) {
    if (!output.music) {
        return {};
    }
    CAROM_ASSERT(context.music != nullptr);
    try {
        return context.music(*output.music, film_samples);
    } catch (const Error& error) {
        throw InputError(std::string("the film's music cannot be played: ") + error.what());
    }
}

sound::AddedSound film_music(const ShotInput& input, std::int64_t film_samples,
                             const CommandContext& context) {
    if (!input.shot.output.music) {
        return {};
    }
    CAROM_ASSERT(context.music != nullptr);
    try {
        return context.music(*input.shot.output.music, film_samples);
    } catch (const Error& error) {
        refuse_music(input, error.what(), context.console);
    }
}

void refuse_music(const ShotInput& input, const std::string& reason, Console& console) {
    report_problems(
        {input.source->problem_at({"output", "music"}, pipeline::Severity::error, reason)},
        console);
    throw InputError("the film's music cannot be played");
}

}  // namespace carom::cli
