#include "sound/mix/onsets.h"

#include <algorithm>
#include <functional>

#include "sound/source/settling.h"

namespace carom::sound {
namespace {

/// The first film time from `low` on at which the clip has reached a scene time, by bisection. It
/// has at its end.
double first_reaching(const Clip& clip, double scene_time, bool is_rising, double low) {
    const auto has_reached = [&](double film_time) {
        const double shown = clip.scene_time(film_time);
        return is_rising ? shown >= scene_time : shown <= scene_time;
    };
    if (has_reached(low)) {
        return low;
    }
    for (double high = clip.to;;) {
        const double middle = low + (high - low) / 2;
        if (middle <= low || middle >= high) {
            return high;
        }
        (has_reached(middle) ? high : low) = middle;
    }
}

/// Whether a clip that runs from the scene time `first` to `last` shows this one.
bool shows(double first, double last, double scene_time) {
    return last > first ? first <= scene_time && scene_time < last
                        : last < scene_time && scene_time <= first;
}

bool can_sound(const sim::Event& event) {
    return event.kind == sim::EventKind::impact || event.kind == sim::EventKind::strike;
}

}  // namespace

std::vector<Onset> onsets_of(const SoundScene& scene) {
    std::vector<Onset> onsets;
    for (std::size_t shot = 0; shot < scene.shots.size(); ++shot) {
        const std::vector<sim::Event>& events = scene.shots[shot].timeline->events;
        const std::vector<bool> settles = settling_contacts(scene.shots[shot]);
        for (std::size_t i = 0; i < scene.shots[shot].clips.size(); ++i) {
            const Clip& clip = scene.shots[shot].clips[i];
            const double first = clip.scene_time(clip.from);
            const double last = clip.scene_time(clip.to);
            std::vector<std::size_t> shown;  // in the order in which the clip shows them
            for (std::size_t event = 0; event < events.size(); ++event) {
                if (can_sound(events[event]) && !settles[event] &&
                    shows(first, last, events[event].time)) {
                    shown.push_back(event);
                }
            }
            if (last < first) {
                std::ranges::stable_sort(shown, std::ranges::greater(),
                                         [&](std::size_t event) { return events[event].time; });
            }
            // It does not fall from one event to the next, and events at the same instant have the
            // same number.
            double film_time = clip.from;
            for (const std::size_t event : shown) {
                film_time = first_reaching(clip, events[event].time, last > first, film_time);
                onsets.push_back({film_time, shot, event, i});
            }
        }
    }
    std::ranges::sort(onsets);
    return onsets;
}

}  // namespace carom::sound
