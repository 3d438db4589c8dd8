#include "tests/pipeline/server/running_server.h"

#include <chrono>
#include <stdexcept>
#include <utility>

#include "tests/patience.h"

namespace carom::testing {

using server::Resource;
using server::SocketId;

std::optional<Resource> RecordingSite::find(std::string_view path) {
    const std::scoped_lock lock(mutex_);
    asked_paths_.emplace_back(path);
    const auto found = resources.find(std::string(path));
    return found == resources.end() ? std::nullopt : std::optional(found->second);
}

void RecordingSite::opened(SocketId socket) {
    add("opened " + std::to_string(socket));
}

void RecordingSite::received(SocketId socket, std::string text) {
    add("received " + std::to_string(socket) + " " + text);
}

void RecordingSite::closed(SocketId socket) {
    add("closed " + std::to_string(socket));
}

void RecordingSite::add(std::string event) {
    const std::scoped_lock lock(mutex_);
    events_.push_back(std::move(event));
    changed_.notify_all();
}

std::string RecordingSite::next_event() {
    std::unique_lock lock(mutex_);
    if (!changed_.wait_for(lock, kPatience, [&] { return !events_.empty(); })) {
        return "nothing";
    }
    std::string event = events_.front();
    events_.erase(events_.begin());
    return event;
}

std::vector<std::string> RecordingSite::asked_paths() {
    const std::scoped_lock lock(mutex_);
    return asked_paths_;
}

namespace {

Resource text_resource(const std::string& type, const std::string& text) {
    return {type, std::make_shared<const std::string>(text), ""};
}

}  // namespace

RunningServer::RunningServer(server::ServerOptions options,
                             std::map<std::string, Resource> resources) {
    options.files["/"] = text_resource("text/html; charset=utf-8", "<p>CAROM_NONCE");
    options.files["/main.js"] = text_resource("text/javascript", "let CAROM_NONCE;");
    site.resources = std::move(resources);
    site.resources.try_emplace("/main.js", options.files["/main.js"]);
    server = std::make_unique<server::Server>(std::move(options), site);
    thread_ = std::jthread([this](const std::stop_token& token) { server->run(token); });
}

RunningServer::~RunningServer() {
    stop();
}

void RunningServer::stop() {
    thread_.request_stop();
    wait();
}

void RunningServer::wait() {
    if (thread_.joinable()) {
        thread_.join();
    }
}

std::string RunningServer::host() const {
    return "127.0.0.1:" + std::to_string(port());
}

std::string RunningServer::key() const {
    const std::string address = server->address();
    return address.substr(address.find("key=") + 4);
}

const std::string& RunningServer::read_key() const {
    while (read_key_.empty()) {  // a server with short time limits may close too early
        const std::string page =
            ask("GET /?key=" + key() + " HTTP/1.1\r\nHost: " + host() + "\r\n\r\n").body;
        if (const std::size_t at = page.find("read="); at != std::string::npos) {
            read_key_ = page.substr(at + 5, key().size());
        }
    }
    return read_key_;
}

std::string RunningServer::request(const std::string& target, const std::string& lines,
                                   const std::string& method) const {
    return method + " /" + read_key() + target + " HTTP/1.1\r\nHost: " + host() + "\r\n" + lines +
           "\r\n";
}

std::string RunningServer::page_request(const std::string& target, const std::string& lines) const {
    return "GET /studio" + target + " HTTP/1.1\r\nHost: " + host() + "\r\n" + lines + "\r\n";
}

std::string RunningServer::upgrade(const std::string& lines) const {
    return "GET /socket HTTP/1.1\r\nHost: " + host() +
           "\r\nConnection: Upgrade\r\nUpgrade: websocket\r\nSec-WebSocket-Version: 13\r\n"
           "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n"
           "Sec-WebSocket-Protocol: carom, carom.key." +
           key() + "\r\n" + lines + "\r\n";
}

HttpAnswer RunningServer::ask(const std::string& bytes) const {
    RawClient client(port());
    client.send(bytes);
    return client.read_answer();
}

std::unique_ptr<RawClient> RunningServer::open_socket(int receive_buffer_bytes) {
    auto client = std::make_unique<RawClient>(port(), receive_buffer_bytes);
    client->send(upgrade(origin()));
    if (client->read_answer().status != 101 || !site.next_event().starts_with("opened")) {
        throw std::runtime_error("the server opened no socket");
    }
    return client;
}

}  // namespace carom::testing
