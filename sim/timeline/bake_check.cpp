#include <cmath>
#include <limits>
#include <set>

#include <fmt/core.h>

#include "sim/timeline/bake_format.h"
#include "sim/timeline/event_fields.h"
#include "sim/timeline/rotation_segment.h"
#include "sim/timeline/track_fields.h"

namespace carom::sim {

namespace {

using Problem = std::optional<std::string>;

// Beyond these values, sampling could overflow. A day's free fall stays far below them.
constexpr double kLargestValue = 1e12;  // m, m/s, rad/s, s
constexpr double kFastestJump = 1e15;   // m/s, from one key to the next, unless the track jumps

bool is_within(double value, double largest) {
    return std::abs(value) <= largest;
}
bool is_within(const Vec3& v, double largest) {
    return is_within(v.x, largest) && is_within(v.y, largest) && is_within(v.z, largest);
}

/// True if no number among the fields is NaN or larger than `largest`.
template <Described T>
bool has_numbers_within(const T& value, double largest) {
    bool is_good = true;
    for_each_field(value, [&](const auto& /*field*/, const auto& member) {
        if constexpr (requires { is_within(member, largest); }) {
            is_good = is_good && is_within(member, largest);
        }
    });
    return is_good;
}

template <Described T>
bool is_finite(const T& value) {
    return has_numbers_within(value, std::numeric_limits<double>::max());
}

Problem keys_problem(const Track& track) {
    const auto problem = [&](std::size_t index, const char* what) {
        return fmt::format("track '{}', key {}: {}", track.name(), index, what);
    };
    const auto keys = track.keys();
    for (std::size_t index = 0; index < keys.size(); ++index) {
        const Key& key = keys[index];
        if (!has_numbers_within(key, kLargestValue)) {
            return problem(index, "a value is larger than 1e12");
        }
        if (index > 0 && !track.jumps_after(index - 1) &&
            !((key.position - keys[index - 1].position).length() <=
              kFastestJump * (key.time - keys[index - 1].time))) {
            return problem(index,
                           "its position is too far from that of the previous key for the time "
                           "between them");
        }
    }
    return {};
}

Problem tracks_problem(const std::vector<Track>& tracks) {
    if (tracks.size() > kMaxTracks) {
        return fmt::format("it has more than {} tracks", kMaxTracks);
    }
    std::set<std::string_view> names;
    std::uint64_t substeps_in_all = 0;
    for (const Track& track : tracks) {
        if (track.name().empty()) {
            return "a track has no name";
        }
        if (track.name().size() > kLongestName) {
            return fmt::format("the name of a track is longer than {} bytes", kLongestName);
        }
        if (!names.insert(track.name()).second) {
            return "two tracks have the name '" + track.name() + "'";
        }
        if (Problem problem = keys_problem(track)) {
            return problem;
        }
        substeps_in_all += rotation_substeps(track.keys());
    }
    if (substeps_in_all > kMaxSubsteps) {
        return "its objects turn more than 1e6 rad about changing axes";
    }
    return {};
}

Problem event_problem(const Event& event) {
    if (event.kind < EventKind::impact || event.kind > EventKind::removed) {
        return "is of an unknown kind";
    }
    if (event.a.size() > kLongestName || event.b.size() > kLongestName) {
        return fmt::format("has a name of more than {} bytes", kLongestName);
    }
    if (!is_finite(event)) {
        return "has a value that is not finite";
    }
    if (event.end_time < event.time) {
        return "ends before it begins";
    }
    return {};
}

Problem energy_problem(const EnergySample& sample) {
    if (!is_finite(sample)) {
        return "has a value that is not finite";
    }
    return {};
}

Problem contact_problem(const LastingContact& contact) {
    if (contact.a.size() > kLongestName || contact.b.size() > kLongestName) {
        return fmt::format("has a name of more than {} bytes", kLongestName);
    }
    if (!is_finite(contact)) {
        return "has a value that is not finite";
    }
    if (contact.to < contact.from) {
        return "ends before it begins";
    }
    if (contact.normal_force < 0 || contact.slip < 0) {
        return "has a negative force or slip";
    }
    return {};
}

Problem put_back_problem(const PutBack& put_back) {
    if (put_back.ball.size() > kLongestName) {
        return fmt::format("has a name of more than {} bytes", kLongestName);
    }
    if (!is_finite(put_back)) {
        return "has a value that is not finite";
    }
    return {};
}

/// The first problem of an element, or of the order of times. `noun`: "event".
template <class Value>
Problem list_problem(const std::vector<Value>& values, const char* noun, double Value::*time,
                     Problem (*problem_of)(const Value&)) {
    for (std::size_t index = 0; index < values.size(); ++index) {
        if (const Problem problem = problem_of(values[index])) {
            return fmt::format("{} {} {}", noun, index, *problem);
        }
        if (index > 0 && values[index].*time < values[index - 1].*time) {
            return fmt::format("{} {} is earlier than the previous one", noun, index);
        }
    }
    return {};
}

Problem warnings_problem(const std::vector<Diagnostic>& warnings) {
    if (warnings.size() > kMaxWarnings) {
        return fmt::format("it has more than {} warnings", kMaxWarnings);
    }
    for (std::size_t index = 0; index < warnings.size(); ++index) {
        const Diagnostic& warning = warnings[index];
        const std::string name = fmt::format("warning {}", index);
        if (warning.subject.kind > Subject::Kind::object) {
            return name + " is about a subject of an unknown kind";
        }
        if (warning.subject.name.size() > kLongestName || warning.field.size() > kLongestName) {
            return fmt::format("{} has a subject with a name of more than {} bytes", name,
                               kLongestName);
        }
        if (warning.sentence.empty() || warning.sentence.size() > kLongestSentence) {
            return fmt::format("{} has no sentence, or one of more than {} bytes", name,
                               kLongestSentence);
        }
        if (warning.severity != Severity::warning) {
            return name + " has the severity of an error";
        }
    }
    return {};
}

Problem assets_problem(const std::vector<Asset>& assets) {
    if (assets.size() > kMaxAssets) {
        return fmt::format("it has more than {} assets", kMaxAssets);
    }
    for (const Asset& asset : assets) {
        if (asset.path.size() > kLongestPath) {
            return fmt::format("the path of an asset is longer than {} bytes", kLongestPath);
        }
    }
    return {};
}

}  // namespace

Problem find_problem(const Bake& bake) {
    const Timeline& timeline = bake.timeline;
    if (!std::isfinite(timeline.start_time) || !std::isfinite(timeline.end_time)) {
        return "its start or end time is not finite";
    }
    if (timeline.end_time < timeline.start_time) {
        return "it ends before it starts";
    }
    if (Problem problem = tracks_problem(timeline.tracks)) {
        return problem;
    }
    if (Problem problem = list_problem(timeline.events, "event", &Event::time, event_problem)) {
        return problem;
    }
    if (Problem problem =
            list_problem(timeline.energy, "energy sample", &EnergySample::time, energy_problem)) {
        return problem;
    }
    if (Problem problem = list_problem(timeline.lasting_contacts, "lasting contact",
                                       &LastingContact::from, contact_problem)) {
        return problem;
    }
    if (Problem problem =
            list_problem(timeline.put_backs, "ball put back", &PutBack::time, put_back_problem)) {
        return problem;
    }
    if (Problem problem = warnings_problem(timeline.warnings)) {
        return problem;
    }
    return assets_problem(bake.assets);
}

}  // namespace carom::sim
