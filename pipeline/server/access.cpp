#include "pipeline/server/access.h"

#include <utility>

#include "pipeline/server/secret.h"

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

Access::Access(std::uint16_t port, std::string key)
    : key_(std::move(key)),
      host_("127.0.0.1:" + std::to_string(port)),
      local_name_("localhost:" + std::to_string(port)),
      cookie_name_("carom_" + std::to_string(port)) {}

std::string Access::cookie() const {
    return cookie_name_ + "=" + key_ + "; HttpOnly; SameSite=Strict; Path=/";
}

bool Access::is_own_host(const Request& request) const {
    const std::string_view host = request.value("host");
    return request.count("host") == 1 && (host == host_ || host == local_name_);
}

bool Access::has_cookie(const Request& request) const {
    bool found = false;
    for (const auto& [name, value] : request.fields) {
        std::string_view left = name == "cookie" ? std::string_view(value) : std::string_view();
        while (!left.empty()) {
            const std::size_t end = std::min(left.find(';'), left.size());
            const std::string_view pair = trimmed(left.substr(0, end));
            left.remove_prefix(std::min(end + 1, left.size()));
            const std::size_t equals = pair.find('=');
            if (equals != std::string_view::npos && pair.substr(0, equals) == cookie_name_) {
                found = is_secret(pair.substr(equals + 1), key_) || found;
            }
        }
    }
    return found;
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
    const bool brings_key = request.target.starts_with(kKeyPrefix);
    const bool is_known =
        brings_key ? is_secret(std::string_view(request.target).substr(kKeyPrefix.size()), key_)
                   : has_cookie(request);
    if (!is_known) {
        return Verdict::unknown_client;
    }
    if (request.method != "GET" && request.method != "HEAD") {
        return Verdict::wrong_method;
    }
    if (has_body(request)) {
        return Verdict::has_body;
    }
    return brings_key ? Verdict::welcome : Verdict::allowed;
}

}  // namespace carom::server
