#include "pipeline/cli/page_server.h"

#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <optional>
#include <utility>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "pipeline/cli/duration_text.h"
#include "pipeline/server/page_files.h"
#include "pipeline/server/private_page.h"

namespace carom::cli {

namespace {

std::map<std::string, server::Resource> read_page() {
    const std::string folder = installed_path("share/carom/studio");
    for (const char* page : {"/index.html", "/farm.html"}) {  // one may be of an older version
        if (!std::filesystem::exists(folder + page)) {
            throw Error("the studio's page is missing: '" + folder + page +
                        "' does not exist; in carom's source tree 'scripts/run studio' builds it");
        }
    }
    return server::read_page_files(folder);
}

/// Starts a program that goes on by itself: the signals of this terminal do not reach it, and it
/// reads and writes nothing there. Returns 0 or an error number.
int start_detached(const std::string& program, char* const* arguments, pid_t& process) {
    posix_spawnattr_t attributes;
    ::posix_spawnattr_init(&attributes);
    sigset_t defaults;
    ::sigfillset(&defaults);
    ::posix_spawnattr_setsigdefault(&attributes, &defaults);
    ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSID | POSIX_SPAWN_SETSIGDEF);
    posix_spawn_file_actions_t files;
    ::posix_spawn_file_actions_init(&files);
    for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        ::posix_spawn_file_actions_addopen(&files, descriptor, "/dev/null", O_RDWR, 0);
    }
    const int error =
        ::posix_spawnp(&process, program.c_str(), &files, &attributes, arguments, environ);
    ::posix_spawn_file_actions_destroy(&files);
    ::posix_spawnattr_destroy(&attributes);
    return error;
}

/// Opens a file in the user's browser. Returns false if no program for that was found.
bool open_in_browser(std::string path) {
    const char* chosen = std::getenv("BROWSER");
    std::string program = chosen != nullptr && *chosen != '\0' ? chosen : "xdg-open";
    const std::array<char*, 3> arguments{program.data(), path.data(), nullptr};
    pid_t process = 0;
    if (start_detached(program, arguments.data(), process) != 0) {
        return false;
    }
    // Browsers that are not running yet stay in the foreground: they are not waited for. A program
    // that fails at once is one that found no browser.
    int status = 0;
    for (int tenths = 0; tenths < 5; ++tenths) {
        if (::waitpid(process, &status, WNOHANG) == process) {
            return WIFEXITED(status) && WEXITSTATUS(status) == 0;
        }
        ::usleep(100'000);
    }
    return true;
}

}  // namespace

std::string installed_path(const std::string& name) {
    std::error_code ignored;
    const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", ignored);
    return (self.parent_path() / "../.." / name).lexically_normal().string();
}

server::ServerOptions server_options(const PageOptions& page) {
    server::ServerOptions options;
    options.port = static_cast<std::uint16_t>(page.port);
    options.files = read_page();
    options.idle = std::chrono::duration_cast<std::chrono::milliseconds>(parse_duration(page.idle));
    return options;
}

void serve(server::Server& server, const PageOptions& options, CommandContext& context) {
    std::optional<server::PrivatePage> page;
    if (!options.no_browser) {
        page.emplace(server.address());
        if (!open_in_browser(page->path())) {
            context.console.info("no browser was found; open the address above in one");
        }
    }
    server.run(context.stop);
}

}  // namespace carom::cli
