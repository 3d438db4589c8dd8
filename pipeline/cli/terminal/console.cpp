#include "pipeline/cli/terminal/console.h"

#include <array>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <mutex>

#include <fmt/core.h>

#include "core/printable.h"
#include "pipeline/cli/terminal/progress_text.h"

namespace carom::cli {

namespace {

constexpr double kSecondsBetweenBars = 0.1;
constexpr double kSecondsBeforeFirstLine = 2;
constexpr double kSecondsBetweenLines = 5;
constexpr int kDefaultColumns = 80;

// ECMA-48: carriage return and erase the line; colours.
constexpr const char* kEraseLine = "\r\x1b[K";
constexpr const char* kRed = "\x1b[1;31m";
constexpr const char* kYellow = "\x1b[1;33m";
constexpr const char* kPlain = "\x1b[0m";

std::string utc_text(std::chrono::system_clock::time_point time) {
    const auto milliseconds =
        std::chrono::duration_cast<std::chrono::milliseconds>(time.time_since_epoch()).count();
    const std::time_t seconds = std::chrono::system_clock::to_time_t(time);
    std::tm calendar{};
    gmtime_r(&seconds, &calendar);
    std::array<char, 32> date{};
    std::strftime(date.data(), date.size(), "%Y-%m-%dT%H:%M:%S", &calendar);
    return fmt::format("{}.{:03}Z", date.data(), milliseconds % 1000);
}

/// Writes to the terminal and keeps the bar below the lines.
class Screen {
  public:
    explicit Screen(ConsoleSettings settings) : settings_(std::move(settings)) {}

    [[nodiscard]] const ConsoleSettings& settings() const { return settings_; }

    void write_lines(const std::string& lines) {
        settings_.write((bar_.empty() ? "" : kEraseLine) + lines + bar_);
    }

    void draw_bar(const std::string& bar) {
        bar_ = bar;
        settings_.write(kEraseLine + bar_);
    }

    void erase_bar() {
        if (!bar_.empty()) {
            bar_.clear();
            settings_.write(kEraseLine);
        }
    }

  private:
    ConsoleSettings settings_;
    std::string bar_;
};

std::string coloured(const std::string& text, const char* colour, bool wanted) {
    return wanted ? colour + text + kPlain : text;
}

/// {"time":...,"NAME":"VALUE",members}
std::string json_line(const char* name, std::string_view value, const JsonMembers& members) {
    JsonMembers all;
    all.add("time", utc_text(std::chrono::system_clock::now())).add(name, value).add(members);
    return all.object() + "\n";
}

}  // namespace

struct Console::State {
    explicit State(ConsoleSettings given) : screen(std::move(given)) {}

    /// Writes a message as text or JSON. `level`: "info", "warning" or "error".
    void write_message(const char* level, const std::string& prefix, const std::string& message) {
        const std::lock_guard lock(mutex);
        screen.write_lines(screen.settings().json
                               ? json_line("level", level, JsonMembers().add("message", message))
                               : "carom: " + prefix + printable(message) + "\n");
    }

    std::mutex mutex;
    Screen screen;
    std::string last_stage;
    double next_progress = 0;
};

Console::Console(ConsoleSettings settings) {
    if (!settings.columns) {
        settings.columns = [] { return kDefaultColumns; };
    }
    state_ = std::make_unique<State>(std::move(settings));
}

Console::~Console() {
    end_progress();
}

void Console::info(const std::string& message) {
    if (!state_->screen.settings().quiet) {
        state_->write_message("info", "", message);
    }
}

bool Console::prints_info() const {
    return !state_->screen.settings().quiet;
}

void Console::warning(const std::string& message) {
    state_->write_message("warning", warning_word("warning:") + " ", message);
}

void Console::error(const std::string& message) {
    state_->write_message("error", error_word("error:") + " ", message);
}

std::string Console::error_word(const std::string& word) const {
    return coloured(word, kRed, state_->screen.settings().colour);
}

std::string Console::warning_word(const std::string& word) const {
    return coloured(word, kYellow, state_->screen.settings().colour);
}

void Console::event(std::string_view kind, const JsonMembers& members, const std::string& text,
                    bool important) {
    const std::lock_guard lock(state_->mutex);
    const ConsoleSettings& settings = state_->screen.settings();
    if (settings.quiet && !important) {
        return;
    }
    if (settings.json) {
        state_->screen.write_lines(json_line("event", kind, members));
    } else if (!text.empty()) {
        state_->screen.write_lines(text);
    }
}

void Console::progress(const ProgressSnapshot& snapshot) {
    const std::lock_guard lock(state_->mutex);
    State& state = *state_;
    const ConsoleSettings& settings = state.screen.settings();
    if (settings.quiet) {
        return;
    }
    const bool has_bar = settings.terminal && !settings.json;
    const double now = settings.clock();
    if (snapshot.stage != state.last_stage) {
        state.last_stage = snapshot.stage;
        // No line is written for a stage that ends within this time.
        state.next_progress = now + (has_bar || settings.json ? 0 : kSecondsBeforeFirstLine);
    }
    if (now < state.next_progress) {
        return;
    }
    state.next_progress = now + (has_bar ? kSecondsBetweenBars : kSecondsBetweenLines);
    if (settings.json) {
        state.screen.write_lines(json_line("event", "progress", progress_json(snapshot)));
    } else if (has_bar) {
        state.screen.draw_bar(progress_bar(snapshot, settings.columns() - 1));
    } else {
        state.screen.write_lines("carom: " + progress_line(snapshot) + "\n");
    }
}

void Console::end_progress() {
    const std::lock_guard lock(state_->mutex);
    state_->screen.erase_bar();
}

}  // namespace carom::cli
