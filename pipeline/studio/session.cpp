#include "pipeline/studio/session.h"

#include <filesystem>
#include <span>
#include <utility>

#include "pipeline/config/schema.h"
#include "pipeline/studio/config_list.h"
#include "pipeline/studio/message_json.h"
#include "pipeline/studio/paths.h"
#include "pipeline/studio/session_state.h"

namespace carom::studio {

namespace fs = std::filesystem;

namespace {

std::string root_of(const SessionOptions& options) {
    std::error_code ignored;
    return fs::weakly_canonical(!options.root.empty()  ? fs::path(options.root)
                                : options.shot.empty() ? fs::current_path()
                                                       : fs::absolute(options.shot).parent_path(),
                                ignored)
        .string();
}

}  // namespace

Session::State::State(SessionOptions options, Send send)
    : options_(std::move(options)), root_(root_of(options_)), messages_(std::move(send)) {
    start_workers();
    if (!options_.shot.empty()) {
        open_shot(options_.shot);
    }
}

void Session::State::start_workers() {
    const auto send = [this](PageId page, const ServerMessage& message) {
        messages_.send(page, message);
    };
    const SessionOptions& o = options_;
    pictures_ = std::make_unique<PictureView>(
        [this](PageId page, const Picture& picture) { send_picture(page, picture); },
        PictureOptions{.cache_folder = o.cache_folder});
    films_ = std::make_unique<SequencePictures>(
        *pictures_,
        SequencePictures::Output{[this](PageId page, const pipeline::TitleCard& card,
                                        const PictureHead& head) { draw_card(page, card, head); },
                                 [this](PageId page, const std::string& why) {
                                     messages_.send(page, Failed{"picture", version(), why});
                                 }});
    fan_ = std::make_unique<OutcomeFan>(
        [this](const FanHead& head, const std::vector<double>& numbers) {
            messages_.send(0, head, std::as_bytes(std::span(numbers)));
        },
        [this](const ServerMessage& message) { messages_.send(0, message); });
    solver_ = std::make_unique<ShotSolver>(
        [this](PageId page, const SolutionsHead& head, const std::vector<double>& numbers) {
            messages_.send(page, head, std::as_bytes(std::span(numbers)));
        },
        send);
    annotations_ = std::make_unique<SceneAnnotations>(
        [this](PageId page, const AnnotationsHead& head, const std::vector<double>& numbers) {
            messages_.send(page, head, std::as_bytes(std::span(numbers)));
        },
        send);
    desk_ = std::make_unique<FileDesk>(o.state_folder, send);
    film_ = std::make_unique<FilmRun>(
        ProgramOptions{o.program, o.overrides, o.quality, o.output, o.cache_folder},
        FilmRun::Output{send, [this](bool running) { pictures_->set_film_running(running); }});
    documents_ = std::make_unique<Documents>(
        ProgramOptions{o.program, o.overrides, o.quality, o.output, o.cache_folder}, send);
    sound_ = std::make_unique<LiveSound>(
        [this](int opening, const SoundState& state) { messages_.send_newest(opening, state); });
    watch_ = std::make_unique<DiskWatch>([this] { return look_at_disk(); });
}

Session::State::~State() {
    desk_->end();
    watch_->end();  // it calls the live shot, which calls it
    live_.reset();
    mesh_work_.end();
    film_.reset();
    documents_.reset();
    pictures_.reset();
}

void Session::State::opened(PageId page) {
    const std::lock_guard lock(mutex_);
    pages_.insert(page);
}

void Session::State::closed(PageId page) {
    const std::lock_guard lock(mutex_);
    pages_.erase(page);
    films_->cancel(page);
    annotations_->cancel(page);
    solver_->cancel(page);
    documents_->closed(page);
    set_dragging(page, false);
}

std::optional<Download> Session::State::find(std::string_view path) {
    if (path == "/schema.json") {
        static const auto schema = std::make_shared<const std::string>(pipeline::schema_json());
        return Download{"application/json", schema, {}};
    }
    if (path == "/configs.json") {
        return Download{
            "application/json", std::make_shared<const std::string>(config_list_json()), {}};
    }
    if (std::optional<Download> film = film_->find(path)) {
        return film;
    }
    if (std::optional<Download> document = documents_->find(path)) {
        return document;
    }
    if (const std::optional<Still> still = desk_->find_still(path)) {
        return Download{still->type, still->bytes, still->path};
    }
    if (path.starts_with(LiveSound::kFolder)) {
        // A newer film may have taken its place while the page asked: that is no error of the page.
        auto piece = sound_->find(path);
        return Download{"application/octet-stream",
                        piece ? std::move(piece) : std::make_shared<const std::string>(),
                        {}};
    }
    constexpr std::string_view kScene = "/scene/";
    constexpr std::string_view kGlb = ".glb";
    if (path.starts_with(kScene) && path.ends_with(kGlb)) {
        path.remove_prefix(kScene.size());
        path.remove_suffix(kGlb.size());
        if (auto bytes = meshes_.find(path)) {
            return Download{"model/gltf-binary", std::move(bytes), {}};
        }
    }
    return std::nullopt;
}

Session::Session(SessionOptions options, Send send)
    : state_(std::make_unique<State>(std::move(options), std::move(send))) {}

Session::~Session() = default;

void Session::opened(PageId page) {
    state_->opened(page);
}

void Session::closed(PageId page) {
    state_->closed(page);
}

void Session::received(PageId page, const std::string& text) {
    state_->received(page, text);
}

std::optional<Download> Session::find(std::string_view path) {
    return state_->find(path);
}

std::string Session::files_root() const {
    return state_->files_root();
}

}  // namespace carom::studio
