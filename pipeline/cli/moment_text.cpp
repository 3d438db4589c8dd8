#include "pipeline/cli/moment_text.h"

#include <algorithm>
#include <cmath>

#include "core/text.h"
#include "pipeline/cli/run_program.h"
#include "pipeline/config/parse_moment.h"
#include "pipeline/config/reader.h"
#include "pipeline/config/text.h"
#include "sim/timeline/surface.h"

namespace carom::cli {

namespace {

/// Throws InputError if the shot has no object of that name.
void check_name(const std::string& option, const std::string& name, const sim::Timeline& timeline,
                const sim::WorldDescription& world) {
    std::vector<std::string> known;
    for (const sim::Body& body : world.bodies) {
        known.push_back(body.name);
    }
    for (const sim::Track& track : timeline.tracks) {
        known.push_back(track.name());
    }
    if (name.empty() || sim::is_surface(name) || std::ranges::find(known, name) != known.end()) {
        return;
    }
    throw InputError(option + ": there is no ball or object " + pipeline::config::quote(name) +
                     pipeline::config::hint(name, known).text);
}

}  // namespace

bool is_moment_text(const std::string& text) {
    return text.starts_with('{');
}

double time_of_moment(const std::string& option, const std::string& text, const ShotInput& input) {
    const auto parsed = pipeline::parse_moment(text);
    if (const auto* problem = std::get_if<std::string>(&parsed)) {
        throw InputError(option + ": " + *problem);
    }
    const sim::Timeline& timeline = input.bake->timeline;
    const auto& moment = std::get<sim::EventTime>(parsed);
    check_name(option, moment.trigger.a, timeline, input.shot.world);
    check_name(option, moment.trigger.b, timeline, input.shot.world);
    const auto found = sim::find_event_time(moment, timeline, input.shot.world);
    if (const auto* reason = std::get_if<std::string>(&found)) {
        throw InputError(option + ": this moment never comes: " + *reason);
    }
    const auto ticks = static_cast<double>(pipeline::config::kMomentTicks);
    return std::round(std::get<double>(found) * ticks) / ticks;
}

}  // namespace carom::cli
