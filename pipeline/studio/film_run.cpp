#include "pipeline/studio/film_run.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <filesystem>
#include <map>
#include <mutex>
#include <thread>
#include <utility>
#include <variant>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "pipeline/camera/frame_plan.h"
#include "pipeline/config/load_shot.h"
#include "pipeline/job/frame_range.h"
#include "pipeline/store/cache_folder.h"
#include "pipeline/studio/child_program.h"
#include "pipeline/studio/film_thumbnails.h"
#include "pipeline/studio/output_path.h"
#include "pipeline/video/image_sequence.h"
#include "pipeline/video/made_by_carom.h"
#include "pipeline/video/picture_kind.h"
#include "pipeline/video/video_format.h"

namespace carom::studio {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostThumbnails = 600;
constexpr std::size_t kMostWarnings = 20;
constexpr int kInterrupted = 130;  // exit code

std::string type_of(const std::string& path) {
    static const std::map<std::string, std::string> types{{".mp4", "video/mp4"},
                                                          {".mov", "video/quicktime"},
                                                          {".mkv", "video/x-matroska"},
                                                          {".webm", "video/webm"}};
    const auto found = types.find(pipeline::extension_of(path));
    return found == types.end() ? "application/octet-stream" : found->second;
}

/// The files that the film would write.
std::vector<std::string> files_of(const std::string& path,
                                  const std::vector<std::int64_t>& frames) {
    if (!pipeline::is_image_sequence(path)) {
        return {path};
    }
    std::vector<std::string> files;
    for (const std::int64_t frame : frames) {
        files.push_back(pipeline::path_in_sequence(path, frame));
    }
    return files;
}

/// The first file that exists; if `may_be_own`, only one that carom did not make.
std::optional<std::string> existing_file(const std::vector<std::string>& files, bool may_be_own) {
    const auto found = std::ranges::find_if(files, [&](const std::string& file) {
        std::error_code ignored;
        return fs::exists(fs::symlink_status(file, ignored)) &&
               !(may_be_own && pipeline::is_made_by_carom(file));
    });
    return found == files.end() ? std::nullopt : std::optional(*found);
}

struct Task {
    PageId page = 0;
    StartFilm request;
    std::string shot;
    std::string root;
};

/// What was found out before the film is begun.
struct Prepared {
    pipeline::Shot shot;
    std::string path;
    std::vector<std::int64_t> frames;
};

}  // namespace

class FilmRun::State {
  public:
    State(FilmRunOptions options, Output output)
        : options_(std::move(options)), output_(std::move(output)) {
        if (options_.cache_folder.empty()) {
            options_.cache_folder = pipeline::default_cache_folder();
        }
    }

    ~State() {
        stop();
        worker_.request_stop();
    }

    State(const State&) = delete;
    State& operator=(const State&) = delete;
    State(State&&) = delete;
    State& operator=(State&&) = delete;

    void start(Task task) {
        {
            const std::lock_guard lock(mutex_);
            if (busy_) {
                throw Error("a film is being made already; stop it before you begin another one");
            }
            busy_ = true;
            stopping_ = false;
        }
        worker_ = {};  // only thumbnails of the last film can be under way
        worker_ = std::jthread(
            [this, task = std::move(task)](const std::stop_token& end) { run(task, end); });
    }

    void stop() {
        const std::lock_guard lock(mutex_);
        stopping_ = busy_;
        if (child_ != nullptr) {
            child_->interrupt();
            if (state_.state == "running") {
                state_.state = "stopping";
                send_state();
            }
        }
    }

    void tell(PageId page) {
        const std::lock_guard lock(mutex_);
        if (!state_.state.empty()) {
            output_.send(page, state_);
        }
        for (const auto& [number, frame] : frames_) {
            output_.send(page, frame);
        }
    }

    std::optional<Download> find(std::string_view address) {
        const std::lock_guard lock(mutex_);
        if (!state_.address.empty() && address == state_.address) {
            return Download{type_of(state_.output), nullptr, state_.output};
        }
        const auto found = thumbnails_.find(address);
        if (found == thumbnails_.end()) {
            return std::nullopt;
        }
        return Download{"image/jpeg", found->second, {}};
    }

  private:
    void run(const Task& task, const std::stop_token& end) {
        try {
            const std::variant<Prepared, Exists> result = prepare(task);
            if (const auto* prepared = std::get_if<Prepared>(&result)) {
                output_.running(true);
                make(task, *prepared, end);
            } else {
                idle([&] { output_.send(task.page, std::get<Exists>(result)); });
            }
        } catch (const std::exception& error) {
            const Failed failed{StartFilm::kName, 0, error.what()};
            idle([&] { output_.send(task.page, failed); });
        }
    }

    /// Another film may begin, also for a page that has only just heard `news` of this one's end.
    void idle(const std::function<void()>& news) {
        output_.running(false);
        const std::lock_guard lock(mutex_);
        child_ = nullptr;
        busy_ = false;
        news();
    }

    /// What the film is made from, or the file that it would replace.
    std::variant<Prepared, Exists> prepare(const Task& task) {
        pipeline::LoadResult loaded = pipeline::load_shot(
            task.shot, {.overrides = overrides(task), .quality = quality(task), .root = task.root});
        if (!loaded.shot) {
            throw Error("the shot has errors, so that no film of it can be made: " +
                        loaded.problems.front().message);
        }
        pipeline::Shot& shot = *loaded.shot;
        pipeline::FrameRange range;
        if (!task.request.frames.empty()) {
            range = pipeline::parse_frame_range(task.request.frames);
        }
        std::vector<std::int64_t> frames =
            range.frames(pipeline::frame_count(shot.cameras, shot.timing));
        if (frames.empty()) {
            throw Error("the film has none of these frames");
        }
        std::string path = output_path(task.request.output, task.shot, options_.output, task.root,
                                       pipeline::default_extension(shot.output));
        const std::string problem = pipeline::check_video_format(
            {shot.render.width, shot.render.height, shot.timing.fps}, shot.output, path);
        if (!problem.empty()) {
            throw Error(problem);
        }
        if (!task.request.overwrite) {
            if (const auto file = existing_file(files_of(path, frames), is_stopped(path))) {
                return Exists{StartFilm::kName, *file,
                              fs::path(*file).lexically_relative(task.root).string()};
            }
        }
        return Prepared{std::move(shot), std::move(path), std::move(frames)};
    }

    /// Whether the last film was stopped and had this output: what it left may be replaced.
    [[nodiscard]] bool is_stopped(const std::string& path) {
        const std::lock_guard lock(mutex_);
        return state_.state == "stopped" && state_.output == path;
    }

    /// The values that replace those of the shot.
    [[nodiscard]] std::vector<std::string> overrides(const Task& task) const {
        std::vector<std::string> all = options_.overrides;
        if (const auto& size = task.request.size) {
            all.push_back(fmt::format("render.size=[{}]", fmt::join(*size, ", ")));
        }
        return all;
    }

    [[nodiscard]] std::string quality(const Task& task) const {
        return task.request.quality.empty() ? options_.quality : task.request.quality;
    }

    [[nodiscard]] std::vector<std::string> words(const Task& task,
                                                 const std::string& output) const {
        std::vector<std::string> all{"render", "--log", "json",   "--cache", options_.cache_folder,
                                     "-o",     output,  "--root", task.root};
        if (const std::string preset = quality(task); !preset.empty()) {
            all.insert(all.end(), {"--quality", preset});
        }
        if (!task.request.frames.empty()) {
            all.insert(all.end(), {"--frames", task.request.frames});
        }
        for (const std::string& value : overrides(task)) {
            all.insert(all.end(), {"--set", value});
        }
        all.insert(all.end(), {"--", task.shot});
        return all;
    }

    /// Ends with idle(), unless it throws.
    void make(const Task& task, const Prepared& prepared, const std::stop_token& end) {
        ChildProgram child(options_.program, words(task, prepared.path));
        {
            const std::lock_guard lock(mutex_);
            begin_ = std::chrono::steady_clock::now();
            state_ = FilmState{};
            state_.state = "running";
            state_.shot = task.shot;
            state_.output = prepared.path;
            state_.width = prepared.shot.render.width;
            state_.height = prepared.shot.render.height;
            state_.fps = prepared.shot.timing.fps.to_double();
            state_.frames = std::ssize(prepared.frames);
            frames_.clear();
            thumbnails_.clear();
            waiting_.clear();
            film_ += 1;
            child_ = &child;
            send_state();
            if (stopping_) {
                child.interrupt();
            }
        }
        const std::jthread artist(
            [&](const std::stop_token& ended) { draw(prepared, ended, end); });
        while (const std::optional<std::string> line = child.next_line()) {
            read(*line);
        }
        const int result = child.wait();
        idle([&] { finish(result); });  // before the last thumbnails
    }

    void finish(int result) {
        state_.left = -1;
        if (result == 0) {
            state_.state = "done";
            state_.fraction = 1;
            if (!pipeline::is_image_sequence(state_.output)) {
                state_.address =
                    "/film/" + std::to_string(film_) + pipeline::extension_of(state_.output);
            }
        } else if (stopping_ || result == kInterrupted) {
            state_.state = "stopped";
        } else {
            state_.state = "failed";
            if (state_.message.empty()) {
                state_.message = result < 0
                                     ? "the renderer was ended by signal " + std::to_string(-result)
                                     : "the renderer ended with code " + std::to_string(result);
            }
        }
        send_state();
    }

    /// Reads a line of the log of `carom render`.
    void read(const std::string& line) {
        const nlohmann::json log = nlohmann::json::parse(line, nullptr, false);
        const std::lock_guard lock(mutex_);
        if (!log.is_object()) {
            state_.message = line;  // of a library, or of the system
            return;
        }
        const std::string event = log.value("event", "");
        const std::string level = log.value("level", "");
        if (level == "error") {
            state_.message = log.value("message", "");
        } else if (level == "warning" && !stopping_ && state_.warnings.size() < kMostWarnings) {
            state_.warnings.push_back(log.value("message", ""));
        } else if (event == "progress" || event == "frame") {
            state_.stage = log.value("stage", "");
            state_.fraction = log.value("fraction", 0.0);
            state_.left = log.value("seconds_left", -1.0);
            state_.finished = log.value("frames_done", state_.finished);
            state_.reused = log.value("frames_found", state_.reused);
        }
        if (event == "frame") {
            waiting_.push_back({log.value("frame", std::int64_t{0}),
                                log.value("found", 0) != 0,
                                log.value("seconds", 0.0),
                                {}});
            drawn_.notify_all();
        }
        send_state();
    }

    /// With the mutex.
    void send_state() {
        const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin_;
        state_.seconds = elapsed.count();
        output_.send(0, state_);
    }

    /// Draws the finished frames and tells the pages of them, until all are drawn and `ended`, or
    /// `cancelled`. Runs beside the reading of the log, which must not wait.
    void draw(const Prepared& prepared, const std::stop_token& ended,
              const std::stop_token& cancelled) {
        const auto every = std::max<std::int64_t>(
            1, std::ssize(prepared.frames) / static_cast<std::int64_t>(kMostThumbnails));
        std::optional<FilmThumbnails> thumbnails;
        bool failed = false;
        std::int64_t count = 0;
        for (;;) {
            FilmFrame frame;
            {
                std::unique_lock lock(mutex_);
                drawn_.wait(lock, ended, [&] { return !waiting_.empty(); });
                if (waiting_.empty() || cancelled.stop_requested()) {
                    return;
                }
                frame = std::move(waiting_.front());
                waiting_.pop_front();
            }
            std::optional<std::string> bytes;
            if (count++ % every == 0 && !failed) {
                try {
                    if (!thumbnails) {
                        thumbnails.emplace(prepared.shot, options_.cache_folder);
                    }
                    bytes = thumbnails->jpeg(frame.frame);
                } catch (const std::exception&) {
                    failed = true;  // the film does not need them
                }
            }
            const std::lock_guard lock(mutex_);
            if (bytes) {
                frame.address = "/film_frame/" + std::to_string(film_) + "/" +
                                std::to_string(frame.frame) + ".jpg";
                thumbnails_[frame.address] = std::make_shared<const std::string>(std::move(*bytes));
            }
            frames_[frame.frame] = frame;
            output_.send(0, frame);
        }
    }

    FilmRunOptions options_;
    Output output_;

    std::mutex mutex_;
    bool busy_ = false;      // a film is being prepared or made
    bool stopping_ = false;  // it is to end
    ChildProgram* child_ = nullptr;
    int film_ = 0;  // number of the film
    FilmState state_;
    std::chrono::steady_clock::time_point begin_;
    std::map<std::int64_t, FilmFrame> frames_;
    std::deque<FilmFrame> waiting_;  // for their thumbnails
    std::map<std::string, std::shared_ptr<const std::string>, std::less<>> thumbnails_;
    std::condition_variable_any drawn_;

    std::jthread worker_;  // ends first; the program that it starts ends with it
};

FilmRun::FilmRun(FilmRunOptions options, Output output)
    : state_(std::make_unique<State>(std::move(options), std::move(output))) {}

FilmRun::~FilmRun() = default;

void FilmRun::start(PageId page, const StartFilm& request, const std::string& shot,
                    const std::string& root) {
    state_->start({page, request, shot, root});
}

void FilmRun::stop() {
    state_->stop();
}

void FilmRun::tell(PageId page) {
    state_->tell(page);
}

std::optional<Download> FilmRun::find(std::string_view address) const {
    return state_->find(address);
}

}  // namespace carom::studio
