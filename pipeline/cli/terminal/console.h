// Prints the messages and the progress of a command on stderr, for users or for programs.
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
    bool quiet = false;     // print only errors and warnings
    bool terminal = false;  // redraw a progress bar; otherwise write a line every few seconds
    bool colour = false;

    std::function<int()> columns{};                 // of the terminal; empty: 80
    std::function<double()> clock{};                // a steady clock, in seconds
    std::function<void(std::string_view)> write{};  // gets whole lines, or the bar with controls
};

/// The settings for stderr of this process. Terminal, width and colour are detected; NO_COLOR and
/// TERM=dumb are respected.
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

    /// Whether info() prints anything: not in quiet mode.
    [[nodiscard]] bool prints_info() const;

    /// `word` in the colour of such messages, if the console uses colour.
    [[nodiscard]] std::string error_word(const std::string& word) const;
    [[nodiscard]] std::string warning_word(const std::string& word) const;

    /// Prints an event of the given kind: `members` as JSON, otherwise `text` (whole lines). If
    /// `important`, it is also printed in quiet mode.
    void event(std::string_view kind, const JsonMembers& members, const std::string& text,
               bool important);

    /// Shows progress: as a bar at most ten times a second, or as a line every few seconds.
    void progress(const ProgressSnapshot& snapshot);

    /// Erases the bar.
    void end_progress();

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace carom::cli
