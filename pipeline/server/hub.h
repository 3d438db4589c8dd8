// What the connections and pages of a server share. Part of server.cpp.
#pragma once

#include <atomic>
#include <map>
#include <memory>
#include <set>
#include <utility>

#include "pipeline/server/boost.h"
#include "pipeline/server/outbox.h"
#include "pipeline/server/responder.h"
#include "pipeline/server/server.h"

namespace carom::server {

class Connection;
class Page;

/// All but touch() is for the thread of run().
struct Hub {
    Hub(ServerOptions server_options, Site& served_site)
        : options(std::move(server_options)),
          limits(options.limits),
          site(served_site),
          outbox(limits.waiting_messages, limits.waiting_bytes) {}

    /// Whether one more connection may be of a client that has the key: one of these that waits for
    /// a request makes room.
    [[nodiscard]] bool has_room_for_known();

    /// Drops the connection of a client without the key that has been idle for longest, if there
    /// are too many.
    void make_room_for_stranger();

    void touch() { last_activity.store(Clock::now().time_since_epoch().count()); }

    ServerOptions options;
    const Limits& limits;
    Site& site;
    Outbox outbox;
    std::unique_ptr<Responder> responder;
    std::set<Connection*> connections;
    std::map<SocketId, Page*> pages;
    SocketId last_id = 0;
    std::atomic<Clock::rep> last_activity = 0;
    // After all that its handlers refer to, because its destructor destroys the waiting ones.
    asio::io_context io{1};
};

}  // namespace carom::server
