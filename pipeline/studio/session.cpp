#include "pipeline/studio/session.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <map>
#include <mutex>
#include <set>
#include <span>
#include <utility>
#include <variant>

#include "core/error.h"
#include "pipeline/config/schema.h"
#include "pipeline/config/shot_source.h"
#include "pipeline/store/cache_folder.h"
#include "pipeline/studio/config_list.h"
#include "pipeline/studio/disk_watch.h"
#include "pipeline/studio/documents.h"
#include "pipeline/studio/file_desk.h"
#include "pipeline/studio/film_run.h"
#include "pipeline/studio/journal.h"
#include "pipeline/studio/live_shot.h"
#include "pipeline/studio/message_json.h"
#include "pipeline/studio/outcome_fan.h"
#include "pipeline/studio/paths.h"
#include "pipeline/studio/picture_view.h"
#include "pipeline/studio/scene_meshes.h"
#include "pipeline/studio/workspace.h"

namespace carom::studio {

class Session::State {
  public:
    State(SessionOptions options, Send send)
        : options_(std::move(options)), send_(std::move(send)) {
        pictures_ = std::make_unique<PictureView>(
            [this](PageId page, const Picture& picture) { send_picture(page, picture); },
            PictureOptions{.cache_folder = options_.cache_folder});
        std::error_code ignored;
        root_ =
            std::filesystem::weakly_canonical(
                !options_.root.empty()  ? std::filesystem::path(options_.root)
                : options_.shot.empty() ? std::filesystem::current_path()
                                        : std::filesystem::absolute(options_.shot).parent_path(),
                ignored)
                .string();
        fan_ = std::make_unique<OutcomeFan>(
            [this](const FanHead& head, const std::vector<double>& numbers) {
                const std::lock_guard lock(send_mutex_);
                send_({0, true, pack(head, std::as_bytes(std::span(numbers))), FanHead::kName});
            },
            [this](const ServerMessage& message) { this->send(0, message); });
        desk_ = std::make_unique<FileDesk>(
            options_.state_folder,
            [this](PageId page, const ServerMessage& message) { this->send(page, message); });
        film_ = std::make_unique<FilmRun>(
            FilmRunOptions{options_.program, options_.overrides, options_.quality, options_.output,
                           options_.cache_folder},
            FilmRun::Output{
                [this](PageId page, const ServerMessage& message) { this->send(page, message); },
                [this](bool running) { pictures_->set_film_running(running); }});
        documents_ = std::make_unique<Documents>(
            DocumentOptions{options_.program, options_.overrides, options_.quality, options_.output,
                            options_.cache_folder},
            [this](PageId page, const ServerMessage& message) { this->send(page, message); });
        watch_ = std::make_unique<DiskWatch>([this] { return look_at_disk(); });
        if (!options_.shot.empty()) {
            open_shot(options_.shot);
        }
    }

    ~State() {
        desk_->end();
        watch_->end();  // it calls the live shot, which calls it
        live_.reset();
        film_.reset();
        documents_.reset();
        pictures_.reset();
    }

    State(const State&) = delete;
    State& operator=(const State&) = delete;
    State(State&&) = delete;
    State& operator=(State&&) = delete;

    void opened(PageId page) {
        const std::lock_guard lock(mutex_);
        pages_.insert(page);
    }

    void closed(PageId page) {
        const std::lock_guard lock(mutex_);
        pages_.erase(page);
        pictures_->cancel(page);
        documents_->closed(page);
        set_dragging(page, false);
    }

    void received(PageId page, const std::string& text) {
        PageMessage message;
        try {
            message = read_page_message(text);
        } catch (const std::exception& error) {
            send(page, Failed{"message", 0, error.what()});
            return;
        }
        std::unique_ptr<LiveShot> ended;  // its thread may need the mutex to end
        const std::lock_guard lock(mutex_);
        std::visit(
            [&](const auto& one) {
                try {
                    receive(page, one);
                } catch (const std::exception& error) {  // the server must not end by a message
                    send(page, Failed{one.kName, version(), error.what()});
                }
            },
            message);
        ended = std::move(ended_);
        if (ended) {  // its work may take a while to stop
            desk_->later(
                [old = std::shared_ptr<LiveShot>(std::move(ended))]() mutable { old.reset(); });
        }
    }

    std::optional<Download> find(std::string_view path) {
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

  private:
    void receive(PageId page, const Hello& hello) {
        if (hello.protocol != kProtocol) {
            throw Error("this page speaks another protocol; load it again");
        }
        send_welcome(page);
        if (!workspace_) {
            send(page, desk_->start());
            return;
        }
        send(page, workspace_->files());
        if (!recovered_.empty()) {
            send(page, Recovered{recovered_});
        }
        film_->tell(page);
        const std::lock_guard lock(send_mutex_);
        for (auto& [slot, message] : newest_) {
            Outgoing copy = message;
            copy.to = page;
            send_(std::move(copy));
        }
    }

    void receive(PageId page, const TextChange& change) {
        const std::int64_t v = require_workspace().set_text(change.v, change.file, change.text);
        offer();
        keep_unsaved();
        for (const PageId other : pages_) {
            if (other != page || v != change.v) {
                send(other, TextChanged{v, change.file, change.text});
            }
        }
    }

    void receive(PageId page, const Save& request) {
        auto result = require_workspace().save(request);
        keep_unsaved();
        if (const auto* saved = std::get_if<Saved>(&result)) {
            send(0, *saved);
        } else {
            send(page, std::get<DiskChanged>(std::move(result)));
        }
    }

    void receive(PageId /*page*/, const Revert& request) {
        require_workspace().revert(request.v, request.file);
        send(0, workspace_->files());
        offer();
        keep_unsaved();
    }

    void receive(PageId page, const Open& request) {
        if (request.file.empty()) {
            close_shot();
            send_welcome(0);
            send(0, desk_->start());
            return;
        }
        open_or_ask(page, desk_->file_to_open(request, root()));
    }

    void receive(PageId page, const SaveAs& request) {
        std::vector<RecoveredText> texts = require_workspace().unsaved();
        std::erase_if(texts, [&](const auto& one) { return one.file == workspace_->shot(); });
        const std::shared_ptr<Journal> journal = journal_;
        std::vector<RecoveredText> unanswered = recovered_;
        unanswered.insert(unanswered.end(), unreachable_.begin(), unreachable_.end());
        if (!open_or_ask(page, desk_->save_as(request, open_texts()))) {
            return;
        }
        journal->keep(std::move(unanswered));  // what is not saved moves to the other shot
        if (workspace_->recover(texts)) {
            offer();
            keep_unsaved();
            send(0, workspace_->files());
        }
    }

    /// Opens the file, or tells the page that it exists.
    bool open_or_ask(PageId page, const std::variant<std::string, Exists>& file) {
        if (const auto* other = std::get_if<Exists>(&file)) {
            send(page, *other);
            return false;
        }
        open_shot(std::get<std::string>(file));
        send_welcome(0);
        send(0, workspace_->files());
        if (!recovered_.empty()) {
            send(0, Recovered{recovered_});
        }
        return true;
    }

    void receive(PageId page, const Offer& /*message*/) { send(page, desk_->start()); }

    void receive(PageId page, const Forget& request) {
        desk_->forget(request.file);
        send(page, desk_->start());
    }

    void receive(PageId page, const ListFolder& request) {
        desk_->answer(page, request, open_texts());
    }

    void receive(PageId page, const Import& request) { desk_->answer(page, request, open_texts()); }

    void receive(PageId page, const ReadParts& request) {
        desk_->answer(page, request, open_texts());
    }

    void receive(PageId page, const AddParts& request) {
        desk_->answer(page, request, open_texts());
    }

    void receive(PageId /*page*/, const Fan& question) { fan_->ask(question); }

    void receive(PageId /*page*/, const Unfan& /*message*/) { fan_->cancel(); }

    void receive(PageId page, const Dragging& dragging) { set_dragging(page, dragging.on); }

    void receive(PageId /*page*/, const Recover& answer) {
        Workspace& workspace = require_workspace();
        const std::vector<RecoveredText> texts = std::exchange(recovered_, {});
        if (answer.use && workspace.recover(texts)) {
            send(0, workspace_->files());
            offer();
        }
        keep_unsaved();
    }

    void receive(PageId /*page*/, const Simulate& /*message*/) {
        if (live_) {
            {
                const std::lock_guard lock(send_mutex_);
                newest_.erase(Deferred::kName);
            }
            live_->simulate();
        }
    }

    void receive(PageId page, const See& question) { pictures_->ask(page, question); }

    void receive(PageId page, const Unsee& /*message*/) { pictures_->cancel(page); }

    void receive(PageId page, const StartFilm& request) {
        film_->start(page, request, require_workspace().shot(), root());
    }

    void receive(PageId /*page*/, const StopFilm& /*message*/) { film_->stop(); }

    void receive(PageId page, const Make& request) {
        documents_->make(page, request, require_workspace().shot(), root());
    }

    void receive(PageId page, const StopMaking& request) { documents_->stop(page, request.q); }

    void send_picture(PageId page, const Picture& picture) {
        if (!picture.problem.empty()) {
            send(page, Failed{"picture", picture.head.v, picture.problem});
            return;
        }
        const std::lock_guard lock(send_mutex_);
        send_({page, true, pack(picture.head, std::as_bytes(std::span(picture.rgba))),
               PictureHead::kName});
    }

    void set_dragging(PageId page, bool on) {
        on ? static_cast<void>(dragging_.insert(page)) : static_cast<void>(dragging_.erase(page));
        if (live_) {
            live_->set_dragging(!dragging_.empty());
        }
        pictures_->hold(Hold::dragging, !dragging_.empty());
    }

    Workspace& require_workspace() {
        if (!workspace_) {
            throw Error("no shot is open");
        }
        return *workspace_;
    }

    /// The folder below which files are written.
    [[nodiscard]] const std::string& root() const {
        return workspace_ ? workspace_->root() : root_;
    }

    [[nodiscard]] OpenShot open_texts() const {
        return workspace_ ? OpenShot{workspace_->shot(), workspace_->root(), workspace_->texts()}
                          : OpenShot{"", root_, {}};
    }

    void send_welcome(PageId page) {
        send(page, Welcome{kProtocol, CAROM_VERSION, version(),
                           workspace_ ? workspace_->shot() : "", root()});
    }

    [[nodiscard]] std::int64_t version() const { return workspace_ ? workspace_->version() : 0; }

    /// Returns the number of the shot that may be opened next.
    int close_shot() {
        ended_ = std::move(live_);
        pictures_->cancel_all();
        fan_->cancel();
        show(nullptr, nullptr, 0);
        watch_->watch({});
        recovered_.clear();
        unreachable_.clear();
        journal_.reset();
        workspace_.reset();
        const std::lock_guard lock(send_mutex_);
        newest_.clear();
        return ++opening_;
    }

    /// What pictures, documents and the fan show.
    void show(const std::shared_ptr<const pipeline::Shot>& shot,
              const std::shared_ptr<const sim::Timeline>& timeline, std::int64_t v) {
        pictures_->set_shot(shot, timeline, v);
        documents_->set_shot(shot, timeline, v);
        fan_->set_shot(shot, timeline, v);
    }

    void open_shot(const std::string& path) {
        // A recent shot may be elsewhere if no root was given.
        std::error_code ignored;
        const bool is_elsewhere =
            options_.root.empty() &&
            !is_below(std::filesystem::weakly_canonical(path, ignored).string(), root_);
        auto workspace = std::make_unique<Workspace>(path, is_elsewhere ? "" : root_);
        const int opening = close_shot();
        workspace_ = std::move(workspace);
        desk_->opened(workspace_->shot());
        open_journal();
        live_ = std::make_unique<LiveShot>(LiveOptions{.overrides = options_.overrides,
                                                       .quality = options_.quality,
                                                       .root = workspace_->root()},
                                           output_of(opening));
        watch_->watch(workspace_->watched());
        offer();
    }

    /// What the thread of a shot has to say; it is dropped once another shot is open.
    LiveOutput output_of(int opening) {
        LiveOutput output;
        output.text = [this, opening](const ServerMessage& message) {
            const auto* problems = std::get_if<Problems>(&message);
            if (problems != nullptr && problems->complete) {
                const std::lock_guard lock(mutex_);
                if (opening == opening_) {
                    pictures_->hold(Hold::texts, false);
                }
            }
            send_newest(opening, message);
        };
        output.binary = [this, opening](const BinaryHead& head,
                                        const std::vector<double>& numbers) {
            keep_and_send(opening, {0, true, pack(head, std::as_bytes(std::span(numbers))),
                                    std::string(name_of(head))});
        };
        output.files = [this, opening](std::int64_t /*v*/,
                                       const std::vector<pipeline::ReadFile>& files,
                                       const std::vector<std::string>& missing) {
            const std::lock_guard lock(mutex_);
            if (opening != opening_) {
                return;
            }
            const bool has_others = workspace_->set_files(files);
            if (has_others) {
                send(0, workspace_->files());
            }
            if (workspace_->set_missing(missing) || has_others) {
                watch_->watch(workspace_->watched());
            }
        };
        output.answer = [this, opening](const LiveAnswer& answer) {
            watch_assets(opening, *answer.source);
            const std::lock_guard lock(mutex_);
            if (opening == opening_) {
                show(answer.shot, answer.timeline, answer.v);
            }
        };
        output.shown = [this, opening](std::int64_t v, const pipeline::Shot& shot) {
            send_newest(opening, SceneMeshes{v, meshes_.add(shot)});
        };
        return output;
    }

    /// The texts that a studio left behind are offered to the pages.
    void open_journal() {
        const std::string& own = options_.cache_folder;
        const std::string cache = own.empty() ? pipeline::default_cache_folder() : own;
        journal_ = std::make_shared<Journal>(workspace_->shot(),
                                             JournalOptions{.folder = cache + "/studio"});
        recovered_ = workspace_->recoverable(journal_->found());
        unreachable_ = workspace_->unreachable(journal_->found());
        keep_unsaved();
    }

    /// The journal has the texts that are not saved, those of which it is not known yet whether
    /// they are to be used, and those that only a studio with another root can use.
    void keep_unsaved() {
        std::vector<RecoveredText> texts = workspace_->unsaved();
        for (const auto* others : {&recovered_, &unreachable_}) {
            for (const RecoveredText& one : *others) {
                if (std::ranges::find(texts, one.file, &RecoveredText::file) == texts.end()) {
                    texts.push_back(one);
                }
            }
        }
        journal_->keep(std::move(texts));
    }

    void watch_assets(int opening, const pipeline::ShotSource& source) {
        std::vector<std::string> paths;
        for (const auto& [node, path] : source.files()) {
            paths.push_back(path);
        }
        const std::lock_guard lock(mutex_);
        if (opening == opening_ && workspace_->set_assets(std::move(paths))) {
            watch_->watch(workspace_->watched());
        }
    }

    /// Returns whether a file is missing and may come again.
    bool look_at_disk() {
        const std::lock_guard lock(mutex_);
        if (!workspace_) {
            return false;
        }
        const Workspace::DiskChanges changes = workspace_->look_at_disk();
        if (changes.reloaded) {
            send(0, workspace_->files());
        }
        for (const DiskChanged& one : changes.conflicting) {
            send(0, one);
        }
        if (changes.reloaded || changes.assets) {
            offer();
        }
        keep_unsaved();
        return changes.missing;
    }

    /// Pictures wait until the newest texts are answered.
    void offer() {
        pictures_->hold(Hold::texts, true);
        fan_->cancel();
        live_->offer({workspace_->version(), workspace_->shot(), workspace_->texts()});
    }

    void send(PageId page, const ServerMessage& message) {
        const std::lock_guard lock(send_mutex_);
        send_({page, false, to_json(message), slot_of(message)});
    }

    /// What a page that takes no messages for a while may miss: a slot each of the film's state, of
    /// a frame, and of the text of a file.
    static std::string slot_of(const ServerMessage& message) {
        if (const auto* frame = std::get_if<FilmFrame>(&message)) {
            return FilmFrame::kName + ("/" + std::to_string(frame->frame));
        }
        if (const auto* text = std::get_if<TextChanged>(&message)) {
            return TextChanged::kName + ("/" + text->file);
        }
        return std::holds_alternative<FilmState>(message) ? FilmState::kName : "";
    }

    /// Sends a message of which only the newest counts, and keeps it for pages that come later.
    void send_newest(int opening, const ServerMessage& message) {
        keep_and_send(opening, {0, false, to_json(message), std::string(name_of(message))});
    }

    /// Drops what belongs to a shot that is no longer open. What is over by now is not kept: an
    /// error of a text, and once a motion is there, that it was left for later.
    void keep_and_send(int opening, Outgoing message) {
        const std::lock_guard lock(send_mutex_);
        if (opening != opening_) {
            return;
        }
        if (message.slot == TimelineHead::kName) {
            newest_.erase(Deferred::kName);
        }
        if (message.slot != Failed::kName) {
            newest_[message.slot] = message;
        }
        send_(std::move(message));
    }

    SessionOptions options_;
    Send send_;
    std::string root_;  // of shots that are below it
    MeshFiles meshes_;

    std::mutex mutex_;  // of the workspace and the pages
    std::unique_ptr<Workspace> workspace_;
    std::shared_ptr<Journal> journal_;      // of the workspace
    std::vector<RecoveredText> recovered_;  // until a page says whether they are to be used
    std::vector<RecoveredText>
        unreachable_;  // of the journal, for files that are not writable here
    std::set<PageId> pages_;
    std::set<PageId> dragging_;

    std::mutex send_mutex_;                   // taken after `mutex_`
    std::map<std::string, Outgoing> newest_;  // by their slots

    int opening_ = 0;  // counts the shots that were opened; changed under both mutexes

    std::unique_ptr<FileDesk> desk_;         // calls send_ from its own thread
    std::unique_ptr<OutcomeFan> fan_;        // calls send_ from its own thread
    std::unique_ptr<PictureView> pictures_;  // calls send_ from its own thread
    std::unique_ptr<Documents> documents_;   // calls send_ from its own threads
    std::unique_ptr<FilmRun> film_;          // calls send_ and the pictures from its own thread
    std::unique_ptr<LiveShot> ended_;        // of the shot before
    std::unique_ptr<LiveShot> live_;         // ends before what it calls
    std::unique_ptr<DiskWatch> watch_;
};

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

}  // namespace carom::studio
