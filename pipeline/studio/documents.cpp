#include "pipeline/studio/documents.h"

#include <array>
#include <atomic>
#include <deque>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <mutex>
#include <set>
#include <utility>

#include <fmt/core.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "core/error.h"
#include "pipeline/plan/plan_svg.h"
#include "pipeline/plan/report_plot.h"
#include "pipeline/report/report_text.h"
#include "pipeline/report/shot_report.h"
#include "pipeline/store/cache_folder.h"
#include "pipeline/studio/child_program.h"
#include "pipeline/studio/errands.h"
#include "pipeline/studio/output_path.h"
#include "pipeline/studio/paths.h"
#include "pipeline/video/picture_kind.h"

namespace carom::studio {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMostKept = 24;

/// What can be made, and how the command line is asked for it.
struct Kind {
    std::string_view what;
    std::string_view command;
    std::string_view option;     // before the file's name
    std::string_view extension;  // if the name has none
    std::string_view suffix;     // of a name that is not given
};

constexpr std::array<Kind, 7> kKinds{{
    {"plan", "plan", "-o", ".svg", "_plan"},
    {"plot", "report", "--plot", ".svg", "_plot"},
    {"report", "report", "-o", ".txt", "_report"},
    {"contact_sheet", "contact-sheet", "-o", ".png", "_sheet"},
    {"frame", "frame", "-o", ".png", "_frame"},
    {"export", "export", "-o", ".csv", ""},
    {"events", "export", "--events", ".csv", "_events"},
}};

const Kind& kind_of(const std::string& what) {
    for (const Kind& kind : kKinds) {
        if (kind.what == what) {
            return kind;
        }
    }
    throw Error("'" + what + "' cannot be made");
}

bool is_rendered(const Kind& kind) {
    return kind.what == "contact_sheet" || kind.what == "frame";
}

std::string type_of(const std::string& path) {
    return media_type_of(path, "text/plain; charset=utf-8");
}

std::string bytes_of(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) {
        throw Error("cannot read '" + path + "'");
    }
    return {std::istreambuf_iterator<char>(file), {}};
}

using Asked = std::pair<PageId, std::int64_t>;

struct Task {
    PageId page = 0;
    Make request;
    std::string shot;
    std::string root;
};

struct Scene {
    std::shared_ptr<const pipeline::Shot> shot;
    std::shared_ptr<const sim::Timeline> timeline;
    std::int64_t v = 0;
};

/// A drawing or the report to look at.
std::string draw(const std::string& what, const Scene& scene) {
    if (what == "plan") {
        return pipeline::plan_svg(*scene.shot, *scene.timeline);
    }
    if (what == "plot") {
        return pipeline::report_plot_svg(*scene.shot, *scene.timeline);
    }
    return pipeline::report_text(pipeline::report_of(*scene.timeline));
}

}  // namespace

class Documents::State {
  public:
    State(DocumentOptions options, Send send)
        : options_(std::move(options)), send_(std::move(send)) {
        if (options_.cache_folder.empty()) {
            options_.cache_folder = pipeline::default_cache_folder();
        }
    }

    ~State() {
        {
            const std::lock_guard lock(mutex_);
            is_ending_ = true;
            if (child_ != nullptr) {
                child_->interrupt();
            }
        }
        programs_.end();
        drawings_.end();
    }

    State(const State&) = delete;
    State& operator=(const State&) = delete;
    State(State&&) = delete;
    State& operator=(State&&) = delete;

    void set_scene(Scene scene) {
        const std::lock_guard lock(mutex_);
        scene_ = std::move(scene);
    }

    void make(Task task) {
        const Kind& kind = kind_of(task.request.what);
        if (task.request.frame < 0 || !(task.request.rate >= 0 && task.request.rate <= 1e6)) {
            throw Error("neither frames nor rates can be negative");
        }
        const bool to_look = task.request.output.empty();
        if (to_look && kind.what != "report" && kind.extension == ".csv") {
            throw Error("an export needs the name of a file");
        }
        Errands& errands = to_look && !is_rendered(kind) ? drawings_ : programs_;
        {
            const std::lock_guard lock(mutex_);
            wanted_.insert({task.page, task.request.q});
            if (!to_look) {
                exports_.insert({task.page, task.request.q});
            }
        }
        const bool is_posted = errands.post([this, &kind, task, to_look] {
            ServerMessage answer;
            try {
                answer = !to_look            ? write(kind, task)
                         : is_rendered(kind) ? render(kind, task)
                                             : look(kind, task);
            } catch (const std::exception& error) {
                answer = Failed{Make::kName, task.request.q, error.what()};
            }
            {
                const std::lock_guard lock(mutex_);
                wanted_.erase({task.page, task.request.q});
                exports_.erase({task.page, task.request.q});
            }
            send_(task.page, answer);
        });
        if (!is_posted) {
            const std::lock_guard lock(mutex_);
            wanted_.erase({task.page, task.request.q});
            exports_.erase({task.page, task.request.q});
            throw Error("too much was asked for at once; try again");
        }
    }

    void stop(const Asked& asked) {
        const std::lock_guard lock(mutex_);
        wanted_.erase(asked);
        if (child_ != nullptr && child_asked_ == asked) {
            child_->interrupt();
        }
    }

    /// Nobody can look at what a closed page asked for; its exports are finished.
    void closed(PageId page) {
        const std::lock_guard lock(mutex_);
        std::erase_if(wanted_, [&](const Asked& asked) {
            return asked.first == page && !exports_.contains(asked);
        });
        if (child_ != nullptr && child_asked_.first == page && !wanted_.contains(child_asked_)) {
            child_->interrupt();
        }
    }

    std::optional<Download> find(std::string_view address) {
        const std::lock_guard lock(mutex_);
        for (const auto& [name, download] : kept_) {
            if (name == address) {
                return download;
            }
        }
        return std::nullopt;
    }

  private:
    ServerMessage look(const Kind& kind, const Task& task) {
        Scene scene;
        {
            const std::lock_guard lock(mutex_);
            scene = scene_;
        }
        if (!scene.shot) {
            throw Error("the shot is not simulated yet");
        }
        return keep(task, scene.v, "x" + std::string(kind.extension),
                    draw(task.request.what, scene));
    }

    /// A picture to look at, which the program writes into the cache.
    ServerMessage render(const Kind& kind, const Task& task) {
        const fs::path folder = fs::path(options_.cache_folder) / "studio";
        fs::create_directories(folder);
        const std::string file =
            (folder / fmt::format("look_{}_{}{}", ::getpid(), number_++, kind.extension)).string();
        std::string bytes;
        try {
            run(kind, task, file);
            bytes = bytes_of(file);
        } catch (const std::exception&) {
            fs::remove(file);
            throw;
        }
        fs::remove(file);
        return keep(task, 0, file, std::move(bytes));
    }

    ServerMessage write(const Kind& kind, const Task& task) {
        const std::string file = output_path(task.request.output, task.shot, options_.output,
                                             task.root, std::string(kind.extension));
        if (!task.request.overwrite && is_there(file)) {
            return Exists{Make::kName, file, fs::path(file).lexically_relative(task.root).string()};
        }
        if (!is_there(fs::path(file).parent_path())) {
            throw Error("the folder of '" + file + "' does not exist");
        }
        if (file == task.shot) {
            throw Error("this is the name of the open shot");
        }
        run(kind, task, file);
        return keep_file(task, file);
    }

    [[nodiscard]] std::vector<std::string> words(const Kind& kind, const Task& task,
                                                 const std::string& file) const {
        const Make& request = task.request;
        std::vector<std::string> all{std::string(kind.command),
                                     "--log",
                                     "json",
                                     "--cache",
                                     options_.cache_folder,
                                     "--root",
                                     task.root,
                                     std::string(kind.option),
                                     file};
        if (kind.what == "report" && pipeline::extension_of(file) == ".json") {
            all.emplace_back("--json");
        }
        if (kind.what == "frame") {
            all.insert(all.end(), {"--frame", std::to_string(request.frame)});
        }
        if (kind.what == "export" && request.rate > 0) {
            all.insert(all.end(), {"--rate", fmt::format("{}", request.rate)});
        }
        if (!options_.quality.empty()) {
            all.insert(all.end(), {"--quality", options_.quality});
        }
        for (const std::string& value : options_.overrides) {
            all.insert(all.end(), {"--set", value});
        }
        all.insert(all.end(), {"--", task.shot});
        return all;
    }

    void run(const Kind& kind, const Task& task, const std::string& file) {
        const Asked asked{task.page, task.request.q};
        {
            const std::lock_guard lock(mutex_);
            require_wanted(asked);
        }
        ChildProgram child(options_.program, words(kind, task, file));
        {
            const std::lock_guard lock(mutex_);
            child_ = &child;
            child_asked_ = asked;
            if (is_ending_ || !wanted_.contains(asked)) {
                child.interrupt();
            }
        }
        std::string message;
        while (const std::optional<std::string> line = child.next_line()) {
            read(*line, task, message);
        }
        const int result = child.wait();
        const std::lock_guard lock(mutex_);
        child_ = nullptr;
        require_wanted(asked);
        if (result != 0) {
            throw Error(!message.empty()         ? message
                        : result == kInterrupted ? "it was stopped"
                                                 : fmt::format("carom ended with code {}", result));
        }
    }

    /// With the mutex. Throws Error.
    void require_wanted(const Asked& asked) const {
        if (is_ending_ || !wanted_.contains(asked)) {
            throw Error("it was stopped");
        }
    }

    /// Reads a line of the program's log; `message` becomes its last error.
    void read(const std::string& line, const Task& task, std::string& message) const {
        const nlohmann::json log = nlohmann::json::parse(line, nullptr, false);
        if (!log.is_object()) {
            message = line;
        } else if (log.value("level", "") == "error") {
            message = log.value("message", "");
        } else if (const std::string event = log.value("event", "");
                   event == "progress" || event == "frame") {
            send_(task.page,
                  Making{task.request.q, log.value("stage", ""), log.value("fraction", 0.0)});
        }
    }

    Made keep(const Task& task, std::int64_t v, const std::string& file, std::string bytes) {
        return keep(
            task, v,
            Download{type_of(file), std::make_shared<const std::string>(std::move(bytes)), {}},
            pipeline::extension_of(file));
    }

    Made keep_file(const Task& task, const std::string& file) {
        Made made =
            keep(task, 0, Download{type_of(file), nullptr, file}, pipeline::extension_of(file));
        made.file = file;
        return made;
    }

    Made keep(const Task& task, std::int64_t v, Download download, const std::string& extension) {
        const std::lock_guard lock(mutex_);
        Made made{task.request.q, v, task.request.what,
                  fmt::format("/made/{}{}", number_++, extension), ""};
        kept_.emplace_back(made.address, std::move(download));
        if (kept_.size() > kMostKept) {
            kept_.pop_front();
        }
        return made;
    }

    DocumentOptions options_;
    Send send_;

    std::mutex mutex_;
    Scene scene_;
    std::set<Asked> wanted_;
    std::set<Asked> exports_;  // of these, those that write a file
    ChildProgram* child_ = nullptr;
    Asked child_asked_;
    bool is_ending_ = false;
    std::atomic<int> number_ = 1;
    std::deque<std::pair<std::string, Download>> kept_;  // by their addresses

    Errands programs_;  // they end first
    Errands drawings_;
};

Documents::Documents(DocumentOptions options, Send send)
    : state_(std::make_unique<State>(std::move(options), std::move(send))) {}

Documents::~Documents() = default;

void Documents::set_shot(std::shared_ptr<const pipeline::Shot> shot,
                         std::shared_ptr<const sim::Timeline> timeline, std::int64_t v) {
    state_->set_scene({std::move(shot), std::move(timeline), v});
}

void Documents::make(PageId page, const Make& request, const std::string& shot,
                     const std::string& root) {
    state_->make({page, request, shot, root});
}

void Documents::closed(PageId page) {
    state_->closed(page);
}

void Documents::stop(PageId page, std::int64_t q) {
    state_->stop({page, q});
}

std::optional<Download> Documents::find(std::string_view address) const {
    return state_->find(address);
}

}  // namespace carom::studio
