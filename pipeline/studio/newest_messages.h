// What a session sends, and what of it a page that comes later needs.
#pragma once

#include <cstddef>
#include <map>
#include <mutex>
#include <span>
#include <string>

#include "pipeline/studio/message_lists.h"
#include "pipeline/studio/session.h"

namespace carom::studio {

/// Sends messages to the pages, one at a time, and keeps the newest ones of the open shot. All
/// functions may be called from any thread. The mutex is held while the server's function is
/// called; a thread that also takes the session's mutex takes that one first.
class NewestMessages {
  public:
    explicit NewestMessages(Session::Send send) : send_(std::move(send)) {}

    /// Sends to a page, or to all (0). Of some messages a page that takes none for a while gets the
    /// last one only: they have slots.
    void send(PageId page, const ServerMessage& message);

    /// The same for a binary message, of which only the newest counts.
    void send(PageId page, const BinaryHead& head, std::span<const std::byte> payload);

    /// Sends a message of which only the newest counts to all pages, and keeps it. It is dropped if
    /// another shot is open than at that opening. What is over by now is not kept: an error of a
    /// text, and once a motion is there, that it was left for later.
    void send_newest(int opening, const ServerMessage& message);
    void send_newest(int opening, const BinaryHead& head, std::span<const std::byte> payload);

    /// Sends what is kept to a page.
    void send_kept(PageId page);

    /// Forgets a message that is over. `name`: its kName.
    void forget(const std::string& name);

    /// Another shot is opened, the number of which is `opening`, or none: nothing is kept.
    void begin(int opening);

  private:
    void keep_and_send(int opening, Outgoing message);

    Session::Send send_;
    std::mutex mutex_;                        // of the members below, and of calls of send_
    std::map<std::string, Outgoing> newest_;  // by their slots
    int opening_ = 0;
};

}  // namespace carom::studio
