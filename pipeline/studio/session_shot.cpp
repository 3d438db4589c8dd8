// The open shot of a session, and what the threads that work on it have to say.
#include <filesystem>
#include <memory>
#include <span>
#include <system_error>
#include <utility>

#include "pipeline/config/shot_source.h"
#include "pipeline/sequence/sequence_writer.h"
#include "pipeline/store/cache_entry.h"
#include "pipeline/store/cache_folder.h"
#include "pipeline/studio/message_json.h"
#include "pipeline/studio/paths.h"
#include "pipeline/studio/session_state.h"
#include "pipeline/studio/shot_root.h"

namespace carom::studio {

/// The root of a shot. If no root was given, a recent shot may be elsewhere, and the shot may name
/// files beside its folder.
std::string Session::State::root_for(const std::string& path) const {
    if (!options_.root.empty()) {
        return root_;
    }
    const std::string file = whole_path(path);
    const std::string folder =
        is_below(file, root_) ? root_ : std::filesystem::path(file).parent_path().string();
    return shot_root(file, folder, {.overrides = options_.overrides, .quality = options_.quality});
}

std::string Session::State::files_root() {
    const std::lock_guard lock(mutex_);
    return root();
}

/// Empty if the cache cannot be used.
std::string Session::State::answers_folder() const {
    try {
        return pipeline::answers_folder(options_.cache_folder.empty()
                                            ? pipeline::default_cache_folder()
                                            : options_.cache_folder);
    } catch (const pipeline::CacheUnusable&) {
        return {};
    }
}

void Session::State::open_shot(const std::string& path) {
    auto shot = std::make_shared<OpenedShot>(path, root_for(path));
    const int opening = close_shot();
    shot_ = std::move(shot);
    desk_->opened(shot_->files().shot());
    shot_->open_journal(options_.cache_folder);
    live_ = std::make_unique<LiveShot>(LiveOptions{.overrides = options_.overrides,
                                                   .quality = options_.quality,
                                                   .root = shot_->files().root(),
                                                   .answers_folder = answers_folder()},
                                       output_of(opening));
    watch_->watch(shot_->files().watched());
    offer();
}

/// Returns the number of the shot that may be opened next.
int Session::State::close_shot() {
    ended_ = std::move(live_);
    pictures_->cancel_all();
    fan_->cancel();
    solver_->cancel(0);
    films_->clear();
    sound_->clear();
    show(nullptr, nullptr, 0);
    watch_->watch({});
    shot_.reset();
    messages_.begin(++opening_);
    return opening_;
}

/// What pictures, documents, the fan and the annotations show.
void Session::State::show(const std::shared_ptr<const pipeline::Shot>& shot,
                          const std::shared_ptr<const sim::Timeline>& timeline, std::int64_t v) {
    pictures_->set_shot(shot, timeline, v);
    documents_->set_shot(shot, timeline, v);
    fan_->set_shot(shot, timeline, v);
    solver_->set_shot(shot, timeline, v);
    annotations_->set_shot(shot, timeline, v);
}

/// The live shot gets the newest texts. Pictures wait until those are answered.
void Session::State::offer() {
    pictures_->hold(Hold::texts, true);
    fan_->cancel();
    solver_->cancel(0);
    const Workspace& files = shot_->files();
    live_->offer({files.version(), files.shot(), files.texts()});
}

/// What the thread of a shot has to say; it is dropped once another shot is open.
LiveOutput Session::State::output_of(int opening) {
    LiveOutput output;
    output.text = [this, opening](const ServerMessage& message) { take_text(opening, message); };
    output.binary = [this, opening](const BinaryHead& head, const std::vector<double>& numbers) {
        messages_.send_newest(opening, head, std::as_bytes(std::span(numbers)));
    };
    output.files = [this, opening](std::int64_t /*v*/, const std::vector<pipeline::ReadFile>& files,
                                   const std::vector<std::string>& missing) {
        take_files(opening, files, missing);
    };
    output.answer = [this, opening](const LiveAnswer& answer) { take_answer(opening, answer); };
    output.sequence = [this, opening](SequenceAnswer answer) {
        take_sequence(opening, std::move(answer));
    };
    output.shown = [this, opening](std::int64_t v, const pipeline::Shot& shot) {
        show_meshes(opening, v, shot);
    };
    return output;
}

void Session::State::show_meshes(int opening, std::int64_t v, const pipeline::Shot& shot) {
    std::string hash = hash_meshes(shot).to_string();
    {
        const std::lock_guard lock(wanted_meshes_mutex_);
        wanted_meshes_ = hash;
    }
    if (meshes_.has(hash)) {
        messages_.send_newest(opening, SceneMeshes{v, std::move(hash)});
        return;
    }
    mesh_work_.post_always([this, opening, v, hash, copy = std::make_shared<pipeline::Shot>(shot)] {
        make_meshes(opening, v, hash, *copy);
    });
}

void Session::State::make_meshes(int opening, std::int64_t v, const std::string& hash,
                                 const pipeline::Shot& shot) {
    {
        const std::lock_guard lock(wanted_meshes_mutex_);
        if (wanted_meshes_ != hash) {
            return;  // newer ones follow
        }
    }
    try {
        messages_.send_newest(opening, SceneMeshes{v, meshes_.add(shot)});
    } catch (const std::exception& error) {
        take_text(opening, Failed{"bake", v, error.what()});
    }
}

void Session::State::take_text(int opening, const ServerMessage& message) {
    const auto* problems = std::get_if<Problems>(&message);
    if (problems != nullptr && problems->complete) {
        const std::lock_guard lock(mutex_);
        if (opening == opening_) {
            pictures_->hold(Hold::texts, false);
        }
    }
    messages_.send_newest(opening, message);
}

void Session::State::take_files(int opening, const std::vector<pipeline::ReadFile>& files,
                                const std::vector<std::string>& missing) {
    const std::lock_guard lock(mutex_);
    if (opening != opening_) {
        return;
    }
    Workspace& own = shot_->files();
    const bool has_others = own.set_files(files);
    if (has_others) {
        messages_.send(0, own.files());
    }
    if (own.set_missing(missing) || has_others) {
        watch_->watch(own.watched());
    }
}

void Session::State::take_answer(int opening, const LiveAnswer& answer) {
    std::vector<std::string> assets;
    for (const sim::Asset& asset : answer.shot->assets) {
        assets.push_back(asset.path);
    }
    const std::lock_guard lock(mutex_);
    if (opening != opening_) {
        return;
    }
    if (shot_->files().set_assets(std::move(assets))) {
        watch_->watch(shot_->files().watched());
    }
    messages_.forget(SequenceState::kName);
    films_->set({});
    show(answer.shot, answer.timeline, answer.v);
    sound_->set(opening, answer.v, [answer] { return heard_film(*answer.shot, *answer.timeline); });
}

void Session::State::take_sequence(int opening, SequenceAnswer answer) {
    std::vector<std::string> assets;
    for (const pipeline::SequencePart& part : answer.sequence->parts) {
        if (const auto* shot = std::get_if<pipeline::ShotPart>(&part.content)) {
            for (const sim::Asset& asset : shot->shot.assets) {
                assets.push_back(asset.path);
            }
            if (shot->bake) {
                assets.push_back(whole_path(shot->path));
            }
        }
    }
    const std::lock_guard lock(mutex_);
    if (opening != opening_) {
        return;
    }
    if (shot_->files().set_assets(std::move(assets))) {
        watch_->watch(shot_->files().watched());
    }
    for (const char* of_shot : {ShotState::kName, CamerasHead::kName, TimelineHead::kName}) {
        messages_.forget(of_shot);
    }
    show(nullptr, nullptr, 0);
    sound_->set(opening, answer.v, [answer] { return heard_film(answer); });
    films_->set(std::move(answer));
}

void Session::State::draw_card(PageId page, const pipeline::TitleCard& card,
                               const PictureHead& head) {
    desk_->later([this, page, card, head] {
        std::vector<std::uint8_t> rgba;
        int channel = 0;
        for (const std::uint16_t value : pipeline::drawn_card(card, head.width, head.height)) {
            rgba.push_back(static_cast<std::uint8_t>((value + 128U) / 257U));
            if (++channel % 3 == 0) {
                rgba.push_back(255);
            }
        }
        messages_.send(page, head, std::as_bytes(std::span(rgba)));
    });
}

void Session::State::send_picture(PageId page, const Picture& picture) {
    if (!picture.problem.empty()) {
        messages_.send(page, Failed{"picture", picture.head.v, picture.problem});
        return;
    }
    messages_.send(page, picture.head, std::as_bytes(std::span(picture.rgba)));
}

/// Returns whether a file is missing and may come again.
bool Session::State::look_at_disk() {
    const std::lock_guard lock(mutex_);
    if (!shot_) {
        return false;
    }
    const Workspace::DiskChanges changes = shot_->files().look_at_disk();
    if (changes.reloaded) {
        messages_.send(0, shot_->files().files());
    }
    for (const DiskChanged& one : changes.conflicting) {
        messages_.send(0, one);
    }
    if (changes.reloaded || changes.assets) {
        offer();
    }
    shot_->keep_unsaved();
    return changes.missing;
}

}  // namespace carom::studio
