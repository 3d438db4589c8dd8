// Everything that a command says to the person or program that called it, on stderr.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "core/json_text.h"
#include "pipeline/cli/terminal/progress_meter.h"

namespace carom::cli {

struct ConsoleSettings {
    bool json = false;      // one JSON object per line, whatever else is set
    bool quiet = false;     // errors and warnings only
    bool terminal = false;  // a bar that is drawn over itself; otherwise a line every few seconds
    bool colour = false;

    std::function<int()> columns{};                 // of the terminal; empty: 80
    std::function<double()> clock{};                // seconds, steady
    std::function<void(std::string_view)> write{};  // whole lines, or the bar with its controls
};

/// stderr of this process: terminal, width and colour as the environment has them (NO_COLOR,
/// TERM=dumb).
[[nodiscard]] ConsoleSettings console_on_stderr(bool json, bool quiet);

/// Lines and the progress bar share the terminal: a line is written above the bar. Any thread may
/// call at any time.
class Console {
  public:
    explicit Console(ConsoleSettings settings);
    ~Console();
    Console(const Console&) = delete;
    Console& operator=(const Console&) = delete;

    void info(const std::string& message);
    void warning(const std::string& message);
    void error(const std::string& message);

    /// `word` as messages of that kind show it: in colour where the terminal has any.
    [[nodiscard]] std::string error_word(const std::string& word) const;
    [[nodiscard]] std::string warning_word(const std::string& word) const;

    /// An event of its own kind: `members` for machines, `text` (whole lines) for people. Not
    /// silenced by quiet if `important`.
    void event(std::string_view kind, const JsonMembers& members, const std::string& text,
               bool important);

    /// Shown at most ten times a second as a bar, every few seconds as a line.
    void progress(const ProgressSnapshot& snapshot);

    /// Takes the bar away.
    void end_progress();

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace carom::cli
