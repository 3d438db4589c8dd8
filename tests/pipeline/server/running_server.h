// A server for tests, on a thread of its own, with a site that remembers what it was told.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "pipeline/server/server.h"
#include "tests/pipeline/server/raw_client.h"

namespace carom::testing {

class RecordingSite : public server::Site {
  public:
    std::optional<server::Resource> find(std::string_view path) override;
    void opened(server::SocketId socket) override;
    void received(server::SocketId socket, std::string text) override;
    void closed(server::SocketId socket) override;

    /// Waits for the next event: "opened 1", "received 1 text", "closed 1". After 30 s: "nothing".
    [[nodiscard]] std::string next_event();
    [[nodiscard]] std::vector<std::string> asked_paths();

    std::map<std::string, server::Resource> resources;  // fill before the server runs

  private:
    void add(std::string event);

    std::mutex mutex_;
    std::condition_variable changed_;
    std::vector<std::string> events_;
    std::vector<std::string> asked_paths_;
};

/// Serves the page files "/" and "/main.js", and the resources of `site`, which has "/main.js",
/// too.
class RunningServer {
  public:
    explicit RunningServer(server::ServerOptions options = {},
                           std::map<std::string, server::Resource> resources = {});
    ~RunningServer();
    RunningServer(const RunningServer&) = delete;
    RunningServer& operator=(const RunningServer&) = delete;

    [[nodiscard]] std::uint16_t port() const { return server->port(); }
    [[nodiscard]] std::string host() const;             // "127.0.0.1:PORT"
    [[nodiscard]] std::string key() const;              // of the address
    [[nodiscard]] const std::string& read_key() const;  // that the page gets, asked for once

    /// The head of a request for something that needs the key, with Host and with these lines
    /// ("Name: value\r\n").
    [[nodiscard]] std::string request(const std::string& target, const std::string& lines = "",
                                      const std::string& method = "GET") const;
    /// The same for a file of the page, which needs none.
    [[nodiscard]] std::string page_request(const std::string& target,
                                           const std::string& lines = "") const;
    /// The head of a request for a WebSocket, with `lines` beside Host and the key.
    [[nodiscard]] std::string upgrade(const std::string& lines) const;
    [[nodiscard]] std::string origin() const { return "Origin: http://" + host() + "\r\n"; }

    /// Sends these bytes over a new connection and returns the answer.
    [[nodiscard]] HttpAnswer ask(const std::string& bytes) const;

    /// Opens a WebSocket and waits until the site knows it.
    [[nodiscard]] std::unique_ptr<RawClient> open_socket(int receive_buffer_bytes = 0);

    /// Ends the server and waits for it.
    void stop();
    /// Waits until the server ends by itself.
    void wait();

    RecordingSite site;
    std::unique_ptr<server::Server> server;

  private:
    std::jthread thread_;
    mutable std::string read_key_;
};

}  // namespace carom::testing
