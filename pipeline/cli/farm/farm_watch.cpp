#include "pipeline/cli/farm/farm_watch.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <sstream>
#include <system_error>
#include <thread>

#include <fmt/core.h>
#include <unistd.h>

#include "core/json_text.h"
#include "pipeline/cli/farm/store_path.h"
#include "pipeline/cli/page_server.h"
#include "pipeline/farm/program.h"
#include "pipeline/server/server.h"

namespace carom::cli {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds kPause{2};  // at least, between two looks at the store
constexpr int kShare = 9;                  // of the time that a look took, so long is the pause
constexpr std::chrono::seconds kSheetPause{15};
constexpr int kSheetShare = 19;
constexpr std::size_t kLongestId = 200;
constexpr std::string_view kSheetFolder = "/sheet/";

/// Whether the text may be an id of a job, which is the name of a folder: no option, no path, and
/// no more than an address of the page may have.
bool is_id(std::string_view text) {
    return !text.empty() && text.size() <= kLongestId && text.front() != '-' &&
           text.find_first_not_of(
               "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"
               "_-.") == std::string_view::npos &&
           text.find_first_not_of('.') != std::string_view::npos;
}

/// A folder for the time of the program.
class OwnFolder {
  public:
    OwnFolder() : path_((fs::temp_directory_path() / "carom-watch-XXXXXX").string()) {
        if (::mkdtemp(path_.data()) == nullptr) {
            throw Error("'" + path_ + "': the folder cannot be made");
        }
    }
    ~OwnFolder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    OwnFolder(const OwnFolder&) = delete;
    OwnFolder& operator=(const OwnFolder&) = delete;

    [[nodiscard]] const std::string& path() const { return path_; }

  private:
    std::string path_;
};

/// The contact sheet of a job as it was last made.
struct Sheet {
    std::shared_ptr<const std::string> bytes;
    std::int64_t number = 0;  // counts the sheets of all jobs; 0: there is none yet
    std::string frames;       // the answer of `farm frames` that it belongs to
    Clock::time_point next{};
};

/// Looks at the store again and again while somebody looks at the page, and tells the page.
class FarmSite : public server::Site {
  public:
    explicit FarmSite(std::string store)
        : store_(std::move(store)), carom_(installed_path("bin/carom")) {}

    /// Looks until it is stopped.
    void run(server::Server& server, const std::stop_token& stop) {
        server_ = &server;
        while (!stop.stop_requested()) {
            const Clock::time_point begin = Clock::now();
            look(stop);
            const Clock::duration pause =
                std::max<Clock::duration>(kPause, kShare * (Clock::now() - begin));
            std::unique_lock lock(mutex_);
            wake_.wait_for(lock, stop, pause, [this] { return is_new_; });
            wake_.wait(lock, stop, [this] { return !pages_.empty(); });
            is_new_ = false;
        }
    }

    std::optional<server::Resource> find(std::string_view path) override {
        if (!path.starts_with(kSheetFolder) || !path.ends_with(".png")) {
            return std::nullopt;
        }
        path.remove_prefix(kSheetFolder.size());
        path.remove_suffix(4);
        const std::lock_guard lock(mutex_);
        const auto sheet = sheets_.find(std::string(path));
        return sheet != sheets_.end() && sheet->second.bytes
                   ? std::optional(server::Resource{"image/png", sheet->second.bytes, ""})
                   : std::nullopt;
    }

    void opened(server::SocketId socket) override { want(socket, ""); }
    /// A page sends the id of the job that it shows, or nothing if it shows none.
    void received(server::SocketId socket, std::string text) override {
        const bool is_known = text.empty() || is_id(text);
        want(socket, is_known ? text : "");
        if (!is_known) {
            JsonMembers members;
            members.add("t", "frames")
                .add("job", text)
                .add("problem",
                     "the page shows only jobs whose folders have simple names: at most " +
                         std::to_string(kLongestId) +
                         " letters, digits and _ - . ; 'carom farm frames FOLDER' shows this one");
            server_->send(socket, {false, members.object(), "frames"});
        }
    }
    void closed(server::SocketId socket) override {
        const std::lock_guard lock(mutex_);
        pages_.erase(socket);
    }

  private:
    void want(server::SocketId socket, std::string job) {
        const std::lock_guard lock(mutex_);
        pages_[socket] = std::move(job);
        is_new_ = true;
        wake_.notify_all();
    }

    [[nodiscard]] std::set<std::string> wanted_jobs() {
        const std::lock_guard lock(mutex_);
        std::set<std::string> jobs;
        for (const auto& [socket, job] : pages_) {
            if (!job.empty()) {
                jobs.insert(job);
            }
        }
        return jobs;
    }

    void look(const std::stop_token& stop) {
        if (!has_pages()) {
            return;
        }
        tell("list", ask({"list", "--json"}), "");
        for (const std::string& job : wanted_jobs()) {
            if (stop.stop_requested()) {
                return;
            }
            const farm::ProgramResult frames = ask({"frames", job, "--json"});
            tell("frames", frames, job);
            if (frames.exit_code == 0) {
                renew_sheet(job, frames.output);
            }
        }
    }

    [[nodiscard]] bool has_pages() {
        const std::lock_guard lock(mutex_);
        return !pages_.empty();
    }

    /// Runs a subcommand of carom farm for the store.
    [[nodiscard]] farm::ProgramResult ask(const std::vector<std::string>& words) const {
        std::vector<std::string> all{carom_, "farm"};
        all.insert(all.end(), words.begin(), words.end());
        all.insert(all.end(), {"--store", store_});
        return farm::run_program(all);
    }

    /// Sends what a subcommand has printed to all pages, or to those that show the job, with the
    /// number of its sheet: in "data", or else its errors in "problem".
    void tell(const std::string& kind, const farm::ProgramResult& result, const std::string& job) {
        JsonMembers members;
        members.add("t", kind).add("job", job);
        const std::lock_guard lock(mutex_);
        if (!job.empty()) {
            members.add("sheet", sheets_[job].number);
        }
        const std::string text =
            result.exit_code == 0 ? fmt::format("{{{},\"data\":{}}}", members.text(), result.output)
                                  : members.add("problem", result.errors).object();
        for (const auto& [socket, shown] : pages_) {
            if (job.empty() || shown == job) {
                server_->send(socket, {false, text, kind});
            }
        }
    }

    /// Makes the sheet again if the frames have changed, and not too often.
    void renew_sheet(const std::string& job, const std::string& frames) {
        {
            const std::lock_guard lock(mutex_);
            const Sheet& sheet = sheets_[job];
            if (sheet.frames == frames || Clock::now() < sheet.next) {
                return;
            }
        }
        const Clock::time_point begin = Clock::now();
        const std::string path = folder_.path() + "/" + job + ".png";
        const farm::ProgramResult made = ask({"status", job, "--sheet", path});
        std::ifstream file(path, std::ios::binary);
        std::ostringstream bytes;
        bytes << file.rdbuf();
        const std::lock_guard lock(mutex_);
        Sheet& sheet = sheets_[job];
        sheet.frames = frames;
        sheet.next = Clock::now() +
                     std::max<Clock::duration>(kSheetPause, kSheetShare * (Clock::now() - begin));
        if (made.exit_code == 0 && file) {
            sheet.bytes = std::make_shared<const std::string>(bytes.str());
            sheet.number = ++made_;
            JsonMembers members;
            members.add("t", "sheet").add("job", job).add("number", sheet.number);
            for (const auto& [socket, shown] : pages_) {
                if (shown == job) {
                    server_->send(socket, {false, members.object(), "sheet"});
                }
            }
        }
    }

    std::string store_;
    std::string carom_;
    OwnFolder folder_;
    server::Server* server_ = nullptr;
    std::mutex mutex_;
    std::condition_variable_any wake_;
    bool is_new_ = false;                            // a page wants something else
    std::map<server::SocketId, std::string> pages_;  // and the job that each shows
    std::map<std::string, Sheet> sheets_;            // by job
    std::int64_t made_ = 0;                          // sheets, of all jobs
};

}  // namespace

void farm_watch(const FarmCommand& command, CommandContext& context) {
    server::ServerOptions options = server_options(command.page);
    options.files["/"] = options.files.at("/farm.html");
    FarmSite site(store_of(command));
    server::Server server(std::move(options), site);
    const std::jthread looking(
        [&](const std::stop_token& stop) { site.run(server, stop); });  // ends before the server
    print_text("carom farm watch: " + server.address() + "\n");
    serve(server, command.page, context);
}

}  // namespace carom::cli
