#include "sound/mix/crossings.h"

#include <algorithm>
#include <functional>
#include <tuple>
#include <vector>

#include "sound/source/settling.h"

namespace carom::sound {
namespace {

/// The first film time of [low, high) at which the passage has reached a scene time. Requires that
/// it has not at `low`, unless that is the passage's beginning, and has at `high`.
double bisect(const Passage& passage, double scene_time, bool is_rising, double low, double high) {
    const auto has_reached = [&](double film_time) {
        const double shown = passage.scene_time(film_time);
        return is_rising ? shown >= scene_time : shown <= scene_time;
    };
    if (has_reached(low)) {
        return low;
    }
    for (;;) {
        const double middle = low + (high - low) / 2;
        if (middle <= low || middle >= high) {
            return high;
        }
        (has_reached(middle) ? high : low) = middle;
    }
}

bool shows(double first, double last, double scene_time) {
    return last > first ? first <= scene_time && scene_time < last
                        : last < scene_time && scene_time <= first;
}

bool can_sound(const sim::Event& event) {
    return event.kind == sim::EventKind::impact || event.kind == sim::EventKind::strike;
}

}  // namespace

std::optional<double> film_time_of(const Passage& passage, double scene_time) {
    const double first = passage.scene_time(passage.from);
    const double last = passage.scene_time(passage.to);
    if (first == last || !shows(first, last, scene_time)) {
        return std::nullopt;
    }
    return bisect(passage, scene_time, last > first, passage.from, passage.to);
}

bool Crossings::Later::operator()(const Cursor& a, const Cursor& b) const {
    const auto key = [](const Crossing& c) {
        return std::tie(c.film_time, c.shot, c.event, c.passage);
    };
    return key(b.at) < key(a.at);
}

Crossings::Crossings(const SoundScene& scene) : scene_(scene) {
    for (std::size_t shot = 0; shot < scene.shots.size(); ++shot) {
        Order& order = orders_.emplace_back();
        const std::vector<sim::Event>& events = scene.shots[shot].timeline->events;
        const std::vector<bool> settles = settling_contacts(scene.shots[shot]);
        for (std::size_t i = 0; i < events.size(); ++i) {
            if (can_sound(events[i]) && !settles[i]) {
                order.forwards.push_back(i);
            }
        }
        order.backwards = order.forwards;
        const auto time = [&](std::size_t i) { return events[i].time; };
        std::ranges::stable_sort(order.backwards, std::ranges::greater(), time);
        for (std::size_t i = 0; i < scene.shots[shot].passages.size(); ++i) {
            waiting_.push_back({shot, i});
        }
    }
    std::ranges::stable_sort(waiting_, [this](const PassageIndex& a, const PassageIndex& b) {
        return passage(a).from > passage(b).from;
    });
}

const Passage& Crossings::passage(const PassageIndex& index) const {
    return scene_.shots[index.shot].passages[index.passage];
}

std::optional<Crossing> Crossings::next_before(double film_time) {
    while (!waiting_.empty() && passage(waiting_.back()).from < film_time &&
           (open_.empty() || passage(waiting_.back()).from <= open_.top().at.film_time)) {
        const PassageIndex index = waiting_.back();
        waiting_.pop_back();
        open(index);
    }
    if (open_.empty() || open_.top().at.film_time >= film_time) {
        return std::nullopt;
    }
    const Cursor cursor = open_.top();
    open_.pop();
    push_next(cursor);
    return cursor.at;
}

void Crossings::open(const PassageIndex& index) {
    const Passage& shown = passage(index);
    const double first = shown.scene_time(shown.from);
    const double last = shown.scene_time(shown.to);
    const std::vector<sim::Event>& events = scene_.shots[index.shot].timeline->events;
    const bool is_backwards = last < first;
    const Order& order = orders_[index.shot];
    const std::vector<std::size_t>& indices = is_backwards ? order.backwards : order.forwards;
    // Those that the passage has behind it when it begins, or ends, at `time`.
    const auto count_before = [&](double time) {
        const auto end = std::ranges::partition_point(indices, [&](std::size_t i) {
            return is_backwards ? events[i].time > time : events[i].time < time;
        });
        return static_cast<std::size_t>(end - indices.begin());
    };
    if (first != last) {
        push_next({{shown.from, index.shot, 0, index.passage},
                   count_before(first),
                   count_before(last),
                   is_backwards});
    }
}

/// Puts the cursor's next event, if it has one, among the open ones.
void Crossings::push_next(Cursor cursor) {
    if (cursor.next >= cursor.end) {
        return;
    }
    const SoundShot& shot = scene_.shots[cursor.at.shot];
    const Order& order = orders_[cursor.at.shot];
    const std::size_t event = (cursor.is_backwards ? order.backwards : order.forwards)[cursor.next];
    const Passage& shown = shot.passages[cursor.at.passage];
    // The film time does not fall from one event to the next, and that of events at the same
    // instant is the same number.
    cursor.at.film_time = bisect(shown, shot.timeline->events[event].time, !cursor.is_backwards,
                                 cursor.at.film_time, shown.to);
    cursor.at.event = event;
    ++cursor.next;
    open_.push(cursor);
}

}  // namespace carom::sound
