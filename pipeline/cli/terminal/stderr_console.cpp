#include <chrono>
#include <cstdlib>
#include <span>

#include <sys/ioctl.h>
#include <unistd.h>

#include "core/write_all.h"
#include "pipeline/cli/terminal/console.h"

namespace carom::cli {

namespace {

constexpr int kDefaultColumns = 80;

bool environment_has(const char* name) {
    const char* value = std::getenv(name);
    return value != nullptr && *value != '\0';
}

int columns_of_stderr() {
    winsize size{};
    const bool known = ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
    return known ? static_cast<int>(size.ws_col) : kDefaultColumns;
}

double steady_seconds() {
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double>(now).count();
}

void write_to_stderr(std::string_view text) {
    // Errors are ignored: the work continues even if stderr was closed.
    static_cast<void>(write_all(STDERR_FILENO, std::as_bytes(std::span(text))));
}

}  // namespace

ConsoleSettings console_on_stderr(bool json, bool quiet) {
    const char* term = std::getenv("TERM");
    ConsoleSettings settings;
    settings.json = json;
    settings.quiet = quiet;
    settings.terminal =
        ::isatty(STDERR_FILENO) == 1 && term != nullptr && std::string_view(term) != "dumb";
    settings.colour = settings.terminal && !environment_has("NO_COLOR");
    settings.columns = columns_of_stderr;
    settings.clock = steady_seconds;
    settings.write = write_to_stderr;
    return settings;
}

}  // namespace carom::cli
