// Connects the studio's session, which knows no socket, to the server, which knows no shot.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "pipeline/server/server.h"
#include "pipeline/studio/session.h"

namespace carom::cli {

/// Passes what the server's clients ask to a session. The server is made first, because the session
/// sends to it from the beginning.
class StudioSite : public server::Site {
  public:
    /// Sets the session, which must outlive Server::run. Call it before that.
    void use(studio::Session& session) { session_ = &session; }

    std::optional<server::Resource> find(std::string_view path) override;
    void opened(server::SocketId socket) override { session_->opened(socket); }
    void received(server::SocketId socket, std::string text) override {
        session_->received(socket, text);
    }
    void closed(server::SocketId socket) override { session_->closed(socket); }

  private:
    studio::Session* session_ = nullptr;
};

}  // namespace carom::cli
