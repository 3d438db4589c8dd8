// The messages that wait to be sent to each socket. Any thread may call at any time.
#pragma once

#include <cstddef>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "pipeline/server/server.h"

namespace carom::server {

class Outbox {
  public:
    /// At most so many messages without a slot wait for one socket, with so many bytes.
    Outbox(std::size_t most_messages, std::size_t most_bytes)
        : most_messages_(most_messages), most_bytes_(most_bytes) {}

    void open(SocketId socket);
    void close(SocketId socket);

    /// Adds the message to the queue of the socket, or of all open sockets for 0. A message with a
    /// slot replaces a waiting one of the same slot.
    void add(SocketId to, Message message);

    /// Takes the next message of a socket; null if none waits.
    [[nodiscard]] std::shared_ptr<const Message> next(SocketId socket);

    /// The sockets for which something was added, or which were overfilled, since the last call.
    struct Changes {
        std::vector<SocketId> filled;
        std::vector<SocketId> overfilled;  // they lost messages, so they must be closed
    };
    [[nodiscard]] Changes take_changes();

  private:
    struct Queue {
        std::deque<std::shared_ptr<const Message>> messages;
        std::size_t bounded_messages = 0;  // without a slot
        std::size_t bounded_bytes = 0;
        bool has_changed = false;
        bool is_overfilled = false;
    };
    void add_to(Queue& queue, const std::shared_ptr<const Message>& message) const;
    static void add_to_slot(Queue& queue, const std::shared_ptr<const Message>& message);

    std::size_t most_messages_;
    std::size_t most_bytes_;
    std::mutex mutex_;  // guards queues_
    std::map<SocketId, Queue> queues_;
};

}  // namespace carom::server
