#include "pipeline/server/access.h"

#include <algorithm>
#include <utility>

#include "pipeline/server/secret.h"
#include "pipeline/server/server.h"

namespace carom::server {

namespace {

constexpr std::string_view kKeyPrefix = "/?key=";  // of the target that brings the key

std::string_view trimmed(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(" \t");
    const std::size_t end = text.find_last_not_of(" \t");
    return begin == std::string_view::npos ? std::string_view()
                                           : text.substr(begin, end - begin + 1);
}

/// Browsers send an Origin with every upgrade, so one without it comes from another program.
bool is_own_origin(const Request& request) {
    const std::size_t count = request.count("origin");
    if (count == 0) {
        return !request.is_upgrade;
    }
    return count == 1 && request.value("origin") == "http://" + std::string(request.value("host"));
}

bool has_body(const Request& request) {
    const std::string_view length = request.value("content-length");
    return !length.empty() && length != "0";
}

}  // namespace

Access::Access(std::uint16_t port, std::string key, std::string read_key)
    : key_(std::move(key)),
      read_key_(std::move(read_key)),
      host_("127.0.0.1:" + std::to_string(port)),
      local_name_("localhost:" + std::to_string(port)) {}

std::string Access::page_with_keys() const {
    return std::string(kPageFolder) + "#key=" + key_ + "&read=" + read_key_;
}

std::string_view Access::path_behind_key(std::string_view target) const {
    return target.substr(std::min(target.size(), 1 + read_key_.size()));
}

bool Access::is_own_host(const Request& request) const {
    const std::string_view host = request.value("host");
    return request.count("host") == 1 && (host == host_ || host == local_name_);
}

bool Access::brings_key(const Request& request) const {
    return request.target.starts_with(kKeyPrefix) &&
           is_secret(std::string_view(request.target).substr(kKeyPrefix.size()), key_);
}

/// Whether the key is among the protocols that a page offers for its WebSocket: the only field of
/// that request which a page can write.
bool Access::names_key(const Request& request) const {
    bool found = false;
    for (const auto& [name, value] : request.fields) {
        std::string_view left =
            name == "sec-websocket-protocol" ? std::string_view(value) : std::string_view();
        while (!left.empty()) {
            const std::size_t end = std::min(left.find(','), left.size());
            const std::string_view protocol = trimmed(left.substr(0, end));
            left.remove_prefix(std::min(end + 1, left.size()));
            if (protocol.starts_with(kKeyProtocol)) {
                found = is_secret(protocol.substr(kKeyProtocol.size()), key_) || found;
            }
        }
    }
    return found;
}

bool Access::has_read_key(std::string_view target) const {
    return is_secret(target.substr(std::min<std::size_t>(target.size(), 1), read_key_.size()),
                     read_key_) &&
           path_behind_key(target).starts_with('/');
}

/// Whether the keys in the request suffice for what it asks for.
Verdict Access::judge_right(const Request& request) const {
    if (brings_key(request)) {
        return Verdict::welcome;
    }
    if (request.target == kSocketPath ? names_key(request) : has_read_key(request.target)) {
        return Verdict::allowed;
    }
    return request.target.starts_with(kPageFolder) ? Verdict::page_file : Verdict::unknown_client;
}

Verdict Access::judge(const Request& request) const {
    if (!is_own_host(request)) {
        return Verdict::foreign_host;
    }
    if (!is_own_origin(request)) {
        return Verdict::foreign_origin;
    }
    if (request.count("transfer-encoding") > 0 || request.count("content-length") > 1) {
        return Verdict::not_understood;
    }
    const Verdict right = judge_right(request);
    if (right == Verdict::unknown_client) {
        return right;
    }
    if (request.method != "GET" && request.method != "HEAD") {
        return Verdict::wrong_method;
    }
    if (has_body(request)) {
        return Verdict::has_body;
    }
    return right;
}

}  // namespace carom::server
