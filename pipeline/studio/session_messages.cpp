// What the messages of a page do.
#include <algorithm>
#include <utility>

#include "core/error.h"
#include "pipeline/studio/message_json.h"
#include "pipeline/studio/session_state.h"

namespace carom::studio {

void Session::State::received(PageId page, const std::string& text) {
    PageMessage message;
    try {
        message = read_page_message(text);
    } catch (const std::exception& error) {
        messages_.send(page, Failed{"message", 0, error.what()});
        return;
    }
    std::unique_ptr<LiveShot> ended;  // its thread may need the mutex to end
    const std::lock_guard lock(mutex_);
    std::visit(
        [&](const auto& one) {
            try {
                receive(page, one);
            } catch (const std::exception& error) {  // the server must not end by a message
                messages_.send(page, Failed{one.kName, version(), error.what()});
            }
        },
        message);
    ended = std::move(ended_);
    if (ended) {  // its work may take a while to stop
        desk_->later(
            [old = std::shared_ptr<LiveShot>(std::move(ended))]() mutable { old.reset(); });
    }
}

// ---- pages ----

void Session::State::receive(PageId page, const Hello& hello) {
    if (hello.protocol != kProtocol) {
        throw Error("this page speaks another protocol; load it again");
    }
    send_welcome(page);
    if (!shot_) {
        messages_.send(page, desk_->start());
        return;
    }
    send_files(page);
    film_->tell(page);
    messages_.send_kept(page);
}

void Session::State::receive(PageId page, const Dragging& dragging) {
    set_dragging(page, dragging.on);
}

void Session::State::set_dragging(PageId page, bool on) {
    on ? static_cast<void>(dragging_.insert(page)) : static_cast<void>(dragging_.erase(page));
    if (live_) {
        live_->set_dragging(!dragging_.empty());
    }
    pictures_->hold(Hold::dragging, !dragging_.empty());
}

void Session::State::send_welcome(PageId page) {
    messages_.send(page, Welcome{kProtocol, CAROM_VERSION, version(),
                                 shot_ ? shot_->files().shot() : "", root(), options_.output});
}

/// Of the open shot, and what a page may recover of them.
void Session::State::send_files(PageId page) {
    messages_.send(page, shot_->files().files());
    if (!shot_->recovered().empty()) {
        messages_.send(page, Recovered{shot_->recovered()});
    }
}

// ---- texts ----

void Session::State::receive(PageId page, const TextChange& change) {
    const std::int64_t v = require_shot().files().set_text(change.v, change.file, change.text);
    offer();
    shot_->keep_unsaved();
    for (const PageId other : pages_) {
        if (other != page || v != change.v) {
            messages_.send(other, TextChanged{v, change.file, change.text, change.base});
        }
    }
}

void Session::State::receive(PageId page, const Save& request) {
    auto result = require_shot().files().save(request);
    shot_->keep_unsaved();
    if (const auto* saved = std::get_if<Saved>(&result)) {
        messages_.send(0, *saved);
    } else {
        messages_.send(page, std::get<DiskChanged>(std::move(result)));
    }
}

void Session::State::receive(PageId /*page*/, const Revert& request) {
    require_shot().files().revert(request.v, request.file);
    messages_.send(0, shot_->files().files());
    offer();
    shot_->keep_unsaved();
}

void Session::State::receive(PageId /*page*/, const Recover& answer) {
    if (require_shot().recover(answer.use)) {
        messages_.send(0, shot_->files().files());
        offer();
    }
    shot_->keep_unsaved();
}

void Session::State::receive(PageId /*page*/, const Simulate& /*message*/) {
    if (live_) {
        messages_.forget(Deferred::kName);
        live_->simulate();
    }
}

// ---- shots ----

void Session::State::receive(PageId page, const Open& request) {
    if (request.file.empty()) {
        close_shot();
        send_welcome(0);
        messages_.send(0, desk_->start());
        return;
    }
    open_or_ask(page, desk_->file_to_open(request, root()));
}

void Session::State::receive(PageId page, const SaveAs& request) {
    static_cast<void>(require_shot());
    const std::shared_ptr<OpenedShot> before = shot_;
    const std::vector<RecoveredText> texts = before->unsaved_of_others();
    if (!open_or_ask(page, desk_->save_as(request, open_texts()))) {
        return;
    }
    before->keep_undecided();  // what is not saved moves to the other shot
    if (shot_->files().recover(texts)) {
        offer();
        shot_->keep_unsaved();
        messages_.send(0, shot_->files().files());
    }
}

/// Opens the file, or tells the page that it exists. Returns whether it was opened.
bool Session::State::open_or_ask(PageId page, const std::variant<std::string, Exists>& file) {
    if (const auto* other = std::get_if<Exists>(&file)) {
        messages_.send(page, *other);
        return false;
    }
    open_shot(std::get<std::string>(file));
    send_welcome(0);
    send_files(0);
    return true;
}

OpenedShot& Session::State::require_shot() {
    if (!shot_) {
        throw Error("no shot is open");
    }
    return *shot_;
}

/// The folder below which files are written.
const std::string& Session::State::root() const {
    return shot_ ? shot_->files().root() : root_;
}

/// Of the texts; 0: no shot is open.
std::int64_t Session::State::version() const {
    return shot_ ? shot_->files().version() : 0;
}

// ---- files beside the shot ----

OpenShot Session::State::open_texts() const {
    if (!shot_) {
        return {"", root_, {}};
    }
    const Workspace& files = shot_->files();
    return {files.shot(), files.root(), files.texts()};
}

void Session::State::receive(PageId page, const Offer& /*message*/) {
    messages_.send(page, desk_->start());
}

void Session::State::receive(PageId page, const Forget& request) {
    desk_->forget(request.file);
    messages_.send(page, desk_->start());
}

void Session::State::receive(PageId page, const ListFolder& request) {
    desk_->answer(page, request, open_texts());
}

void Session::State::receive(PageId page, const Import& request) {
    desk_->answer(page, request, open_texts());
}

void Session::State::receive(PageId page, const ReadParts& request) {
    desk_->answer(page, request, open_texts());
}

void Session::State::receive(PageId page, const AddParts& request) {
    desk_->answer(page, request, open_texts());
}

// ---- pictures, films, documents ----

void Session::State::receive(PageId /*page*/, const Fan& question) {
    fan_->ask(question);
}

void Session::State::receive(PageId /*page*/, const Unfan& /*message*/) {
    fan_->cancel();
}

void Session::State::receive(PageId page, const SolveShot& question) {
    solver_->ask(page, question);
}

void Session::State::receive(PageId page, const Judge& question) {
    solver_->ask(page, question);
}

void Session::State::receive(PageId page, const Unsolve& /*message*/) {
    solver_->cancel(page);
}

void Session::State::receive(PageId page, const See& question) {
    films_->ask(page, question);
}

void Session::State::receive(PageId page, const Unsee& /*message*/) {
    films_->cancel(page);
}

void Session::State::receive(PageId page, const SeeAnnotations& question) {
    annotations_->ask(page, question);
}

void Session::State::receive(PageId page, const StartFilm& request) {
    film_->start(page, request, require_shot().files().shot(), root());
}

void Session::State::receive(PageId /*page*/, const StopFilm& /*message*/) {
    film_->stop();
}

void Session::State::receive(PageId page, const Make& request) {
    documents_->make(page, request, require_shot().files().shot(), root());
}

void Session::State::receive(PageId page, const StopMaking& request) {
    documents_->stop(page, request.q);
}

}  // namespace carom::studio
