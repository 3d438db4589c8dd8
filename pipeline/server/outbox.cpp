#include "pipeline/server/outbox.h"

#include <algorithm>
#include <utility>

namespace carom::server {

void Outbox::open(SocketId socket) {
    const std::scoped_lock lock(mutex_);
    queues_[socket];
}

void Outbox::close(SocketId socket) {
    const std::scoped_lock lock(mutex_);
    queues_.erase(socket);
}

void Outbox::add(SocketId to, Message message) {
    const auto shared = std::make_shared<const Message>(std::move(message));
    const std::scoped_lock lock(mutex_);
    if (to != 0) {
        if (const auto found = queues_.find(to); found != queues_.end()) {
            add_to(found->second, shared);
        }
        return;
    }
    for (auto& [socket, queue] : queues_) {
        add_to(queue, shared);
    }
}

void Outbox::add_to(Queue& queue, const std::shared_ptr<const Message>& message) const {
    if (queue.is_overfilled) {
        return;
    }
    queue.has_changed = true;
    if (!message->slot.empty()) {
        add_to_slot(queue, message);
        return;
    }
    queue.messages.push_back(message);
    queue.bounded_messages += 1;
    queue.bounded_bytes += message->data.size();
    if (queue.bounded_messages > most_messages_ || queue.bounded_bytes > most_bytes_) {
        queue.is_overfilled = true;
        queue.messages.clear();
    }
}

void Outbox::add_to_slot(Queue& queue, const std::shared_ptr<const Message>& message) {
    auto& messages = queue.messages;
    const auto waiting = std::find_if(messages.begin(), messages.end(), [&](const auto& other) {
        return other->slot == message->slot;
    });
    if (waiting == messages.end()) {
        messages.push_back(message);
        return;
    }
    // What has no slot, such as the message that another shot is open, is not overtaken.
    const bool may_stay = std::all_of(waiting, messages.end(),
                                      [](const auto& later) { return !later->slot.empty(); });
    if (may_stay) {
        *waiting = message;
    } else {
        messages.erase(waiting);
        messages.push_back(message);
    }
}

std::shared_ptr<const Message> Outbox::next(SocketId socket) {
    const std::scoped_lock lock(mutex_);
    const auto found = queues_.find(socket);
    if (found == queues_.end() || found->second.messages.empty()) {
        return nullptr;
    }
    Queue& queue = found->second;
    std::shared_ptr<const Message> message = std::move(queue.messages.front());
    queue.messages.pop_front();
    if (message->slot.empty()) {
        queue.bounded_messages -= 1;
        queue.bounded_bytes -= message->data.size();
    }
    return message;
}

Outbox::Changes Outbox::take_changes() {
    Changes changes;
    const std::scoped_lock lock(mutex_);
    for (auto& [socket, queue] : queues_) {
        if (std::exchange(queue.has_changed, false)) {
            (queue.is_overfilled ? changes.overfilled : changes.filled).push_back(socket);
        }
    }
    return changes;
}

}  // namespace carom::server
