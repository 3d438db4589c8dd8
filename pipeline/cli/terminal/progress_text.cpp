#include "pipeline/cli/terminal/progress_text.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/core.h>

#include "pipeline/cli/terminal/duration_text.h"

namespace carom::cli {

namespace {

constexpr int kWidestBar = 40;
constexpr int kNarrowestBar = 8;

// Rounded down, so that 100 % means finished.
std::string percent(double fraction) {
    return fmt::format("{}", std::lround(std::floor(fraction * 100)));
}

std::string bar_of(double fraction, int width) {
    const int filled = static_cast<int>(fraction * width);
    std::string bar(static_cast<std::size_t>(width), ' ');
    std::fill_n(bar.begin(), filled, '=');
    if (filled < width) {
        bar[static_cast<std::size_t>(filled)] = '>';
    }
    return "[" + bar + "]";
}

/// The texts on the right of the bar, the most useful first.
std::vector<std::string> bar_details(const ProgressSnapshot& snapshot) {
    std::vector<std::string> details;
    if (snapshot.frames_total > 0) {
        const std::string total = fmt::format("{}", snapshot.frames_total);
        std::string done = fmt::format("{}", snapshot.frames_done);
        done.insert(0, total.size() - std::min(total.size(), done.size()), ' ');
        details.push_back(done + "/" + total);
    }
    std::string fraction = percent(snapshot.fraction);
    fraction.insert(0, 3 - std::min<std::size_t>(3, fraction.size()), ' ');
    details.push_back(fraction + " %");
    if (snapshot.left) {
        details.push_back(duration_text(*snapshot.left) + " left");
    }
    if (snapshot.rays_rate) {
        details.push_back(rate_text(*snapshot.rays_rate, "rays/s"));
    }
    return details;
}

}  // namespace

std::string progress_bar(const ProgressSnapshot& snapshot, int columns) {
    const auto limit = static_cast<std::size_t>(std::max(columns, 1));
    std::vector<std::string> details = bar_details(snapshot);
    constexpr std::size_t kBrackets = 3;  // and the space before them
    const auto needed = [&] {
        std::size_t length = snapshot.stage.size() + kBrackets;
        for (const std::string& detail : details) {
            length += 2 + detail.size();
        }
        return length;
    };
    while (!details.empty() && needed() + kNarrowestBar > limit) {
        details.pop_back();
    }
    const std::size_t room = limit > needed() ? limit - needed() : 0;
    const auto width = static_cast<int>(std::min<std::size_t>(room, kWidestBar));
    std::string text = snapshot.stage + " " + bar_of(snapshot.fraction, width);
    for (const std::string& detail : details) {
        text += "  " + detail;
    }
    return text.substr(0, limit);
}

std::string progress_line(const ProgressSnapshot& snapshot) {
    std::string text = snapshot.stage + ": ";
    if (snapshot.frames_total > 0) {
        text += fmt::format("{} of {} frames ({} %", snapshot.frames_done, snapshot.frames_total,
                            percent(snapshot.fraction));
        if (snapshot.frames_found > 0) {
            text += fmt::format(", {} stored or shown again", snapshot.frames_found);
        }
        text += ")";
    } else {
        text += percent(snapshot.fraction) + " %";
    }
    if (snapshot.left) {
        text += ", " + duration_text(*snapshot.left) + " left";
    }
    if (snapshot.rays_rate) {
        text += ", " + rate_text(*snapshot.rays_rate, "rays/s");
    }
    return text;
}

JsonMembers progress_json(const ProgressSnapshot& snapshot) {
    JsonMembers members;
    members.add("stage", snapshot.stage).add("fraction", snapshot.fraction);
    if (snapshot.frames_total > 0) {
        members.add("frames_total", snapshot.frames_total)
            .add("frames_done", snapshot.frames_done)
            .add("frames_found", snapshot.frames_found);
    }
    members.add("seconds_elapsed", snapshot.elapsed);
    if (snapshot.left) {
        members.add("seconds_left", *snapshot.left);
    }
    if (snapshot.rays_rate) {
        members.add("rays_per_second", *snapshot.rays_rate);
    }
    return members;
}

JsonMembers frame_json(std::int64_t frame, bool found, double seconds,
                       const ProgressSnapshot& snapshot) {
    JsonMembers members;
    members.add("frame", frame).add("found", found ? 1 : 0).add("seconds", seconds);
    return members.add(progress_json(snapshot));
}

}  // namespace carom::cli
