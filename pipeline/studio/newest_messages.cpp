#include "pipeline/studio/newest_messages.h"

#include <utility>
#include <variant>

#include "pipeline/studio/message_json.h"

namespace carom::studio {
namespace {

/// What a page that takes no messages for a while may miss: a slot each of the film's state, of a
/// frame, and of the text of a file.
std::string slot_of(const ServerMessage& message) {
    if (const auto* frame = std::get_if<FilmFrame>(&message)) {
        return FilmFrame::kName + ("/" + std::to_string(frame->frame));
    }
    if (const auto* text = std::get_if<TextChanged>(&message)) {
        return TextChanged::kName + ("/" + text->file);
    }
    return std::holds_alternative<FilmState>(message) ? FilmState::kName : "";
}

}  // namespace

void NewestMessages::send(PageId page, const ServerMessage& message) {
    const std::lock_guard lock(mutex_);
    send_({page, false, to_json(message), slot_of(message)});
}

void NewestMessages::send(PageId page, const BinaryHead& head, std::span<const std::byte> payload) {
    const std::lock_guard lock(mutex_);
    send_({page, true, pack(head, payload), std::string(name_of(head))});
}

void NewestMessages::send_newest(int opening, const ServerMessage& message) {
    keep_and_send(opening, {0, false, to_json(message), std::string(name_of(message))});
}

void NewestMessages::send_newest(int opening, const BinaryHead& head,
                                 std::span<const std::byte> payload) {
    keep_and_send(opening, {0, true, pack(head, payload), std::string(name_of(head))});
}

void NewestMessages::keep_and_send(int opening, Outgoing message) {
    const std::lock_guard lock(mutex_);
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

void NewestMessages::send_kept(PageId page) {
    const std::lock_guard lock(mutex_);
    for (const auto& [slot, message] : newest_) {
        Outgoing copy = message;
        copy.to = page;
        send_(std::move(copy));
    }
}

void NewestMessages::forget(const std::string& name) {
    const std::lock_guard lock(mutex_);
    newest_.erase(name);
}

void NewestMessages::begin(int opening) {
    const std::lock_guard lock(mutex_);
    newest_.clear();
    opening_ = opening;
}

}  // namespace carom::studio
