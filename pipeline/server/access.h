// Decides who may ask: the rules about Host, Origin, key and cookie.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "pipeline/server/request.h"

namespace carom::server {

/// What to do with a request.
enum class Verdict {
    allowed,
    welcome,         // the key is right: set the cookie, and take the key out of the address bar
    foreign_host,    // 403
    foreign_origin,  // 403
    unknown_client,  // 401
    has_body,        // 413
    wrong_method,    // 405
    not_understood,  // 400
};

class Access {
  public:
    /// `key` is the secret of the server at this port.
    Access(std::uint16_t port, std::string key);

    [[nodiscard]] Verdict judge(const Request& request) const;

    /// "127.0.0.1:PORT"
    [[nodiscard]] const std::string& host() const { return host_; }
    /// "localhost:PORT"
    [[nodiscard]] const std::string& local_name() const { return local_name_; }
    /// The path with the key: "/?key=..."
    [[nodiscard]] std::string key_path() const { return "/?key=" + key_; }
    /// The value of Set-Cookie after a welcome.
    [[nodiscard]] std::string cookie() const;

  private:
    [[nodiscard]] bool is_own_host(const Request& request) const;
    [[nodiscard]] bool has_cookie(const Request& request) const;

    std::string key_;
    std::string host_;
    std::string local_name_;
    std::string cookie_name_;  // with the port, because browsers share cookies among all ports
};

}  // namespace carom::server
