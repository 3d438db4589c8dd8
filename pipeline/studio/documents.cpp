#include "pipeline/studio/documents.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <mutex>
#include <utility>

#include <fmt/core.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "core/error.h"
#include "pipeline/store/cache_folder.h"
#include "pipeline/studio/child_program.h"
#include "pipeline/studio/errands.h"
#include "pipeline/studio/kept_documents.h"
#include "pipeline/studio/output_path.h"
#include "pipeline/studio/paths.h"
#include "pipeline/studio/wanted_documents.h"

namespace carom::studio {

namespace fs = std::filesystem;

namespace {

std::string bytes_of(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) {
        throw Error("cannot read '" + path + "'");
    }
    return {std::istreambuf_iterator<char>(file), {}};
}

struct Task {
    PageId page = 0;
    DocumentRequest request;

    [[nodiscard]] AskedDocument asked() const { return {page, request.make.q}; }
};

struct Scene {
    std::shared_ptr<const pipeline::Shot> shot;
    std::shared_ptr<const sim::Timeline> timeline;
    std::int64_t v = 0;
};

}  // namespace

class Documents::State {
  public:
    State(ProgramOptions options, Send send)
        : options_(std::move(options)), send_(std::move(send)) {
        if (options_.cache_folder.empty()) {
            options_.cache_folder = pipeline::default_cache_folder();
        }
    }

    ~State() {
        wanted_.end();
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
        const DocumentKind& kind = kind_of(task.request.make);
        const AskedDocument asked = task.asked();
        const bool to_look = task.request.make.output.empty();
        wanted_.add(asked, !to_look);
        Errands& errands = to_look && !kind.is_rendered ? drawings_ : programs_;
        const bool is_posted = errands.post([this, &kind, task = std::move(task)] {
            const ServerMessage answer = answer_of(kind, task);
            wanted_.remove(task.asked());
            send_(task.page, answer);
        });
        if (!is_posted) {
            wanted_.remove(asked);
            throw Error("too much was asked for at once; try again");
        }
    }

    void stop(const AskedDocument& asked) { wanted_.stop(asked); }

    void closed(PageId page) { wanted_.closed(page); }

    std::optional<Download> find(std::string_view address) { return kept_.find(address); }

  private:
    ServerMessage answer_of(const DocumentKind& kind, const Task& task) {
        try {
            return !task.request.make.output.empty() ? write(kind, task)
                   : kind.is_rendered                ? render(kind, task)
                                                     : look(kind, task);
        } catch (const std::exception& error) {
            return Failed{Make::kName, task.request.make.q, error.what()};
        }
    }

    ServerMessage look(const DocumentKind& kind, const Task& task) {
        Scene scene;
        {
            const std::lock_guard lock(mutex_);
            scene = scene_;
        }
        if (!scene.shot) {
            throw Error("the shot is not simulated yet");
        }
        return kept_.keep(task.request.make, scene.v, std::string(kind.extension),
                          draw_document(kind, *scene.shot, *scene.timeline));
    }

    /// A picture to look at, which the program writes into the cache.
    ServerMessage render(const DocumentKind& kind, const Task& task) {
        const fs::path folder = fs::path(options_.cache_folder) / "studio";
        fs::create_directories(folder);
        const std::string file =
            (folder / fmt::format("look_{}_{}{}", ::getpid(), looks_++, kind.extension)).string();
        std::string bytes;
        try {
            run(kind, task, file);
            bytes = bytes_of(file);
        } catch (const std::exception&) {
            fs::remove(file);
            throw;
        }
        fs::remove(file);
        return kept_.keep(task.request.make, 0, std::string(kind.extension), std::move(bytes));
    }

    ServerMessage write(const DocumentKind& kind, const Task& task) {
        const DocumentRequest& request = task.request;
        const std::string file = output_path(request.make.output, request.shot, options_.output,
                                             request.root, std::string(kind.extension));
        if (!request.make.overwrite && is_there(file)) {
            return Exists{Make::kName, file,
                          fs::path(file).lexically_relative(request.root).string()};
        }
        if (!is_there(fs::path(file).parent_path())) {
            throw Error("the folder of '" + file + "' does not exist");
        }
        if (file == request.shot) {
            throw Error("this is the name of the open shot");
        }
        run(kind, task, file);
        return kept_.keep_file(request.make, file);
    }

    void run(const DocumentKind& kind, const Task& task, const std::string& file) {
        const AskedDocument asked = task.asked();
        wanted_.require(asked);
        ChildProgram child(options_.program, document_words(kind, task.request, options_, file));
        std::string message;
        int result = 0;
        {
            const WantedDocuments::Running running(wanted_, asked, child);
            while (const std::optional<std::string> line = child.next_line()) {
                read(*line, task, message);
            }
            result = child.wait();
        }
        wanted_.require(asked);
        if (result != 0) {
            throw Error(!message.empty()         ? message
                        : result == kInterrupted ? "it was stopped"
                                                 : fmt::format("carom ended with code {}", result));
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
                  Making{task.request.make.q, log.value("stage", ""), log.value("fraction", 0.0)});
        }
    }

    ProgramOptions options_;
    Send send_;
    KeptDocuments kept_;

    WantedDocuments wanted_;

    std::mutex mutex_;  // of the scene
    Scene scene_;

    int looks_ = 1;  // number of the next picture to look at; of the thread of the programs

    Errands programs_;  // they end first
    Errands drawings_;
};

Documents::Documents(ProgramOptions options, Send send)
    : state_(std::make_unique<State>(std::move(options), std::move(send))) {}

Documents::~Documents() = default;

void Documents::set_shot(std::shared_ptr<const pipeline::Shot> shot,
                         std::shared_ptr<const sim::Timeline> timeline, std::int64_t v) {
    state_->set_scene({std::move(shot), std::move(timeline), v});
}

void Documents::make(PageId page, const Make& request, const std::string& shot,
                     const std::string& root) {
    state_->make({page, {request, shot, root}});
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
