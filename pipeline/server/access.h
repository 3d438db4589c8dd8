// Decides who may ask: the rules about Host, Origin and the keys.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "pipeline/server/request.h"

namespace carom::server {

/// What to do with a request.
enum class Verdict {
    allowed,         // it has the key of what it asks for
    page_file,       // a file of the page, which is no secret
    welcome,         // the key is right: lead to the page, which keeps it
    foreign_host,    // 403
    foreign_origin,  // 403
    unknown_client,  // 401
    has_body,        // 413
    wrong_method,    // 405
    not_understood,  // 400
};

class Access {
  public:
    /// The secrets of the server at this port: `key` lets a page open its socket, `read_key` is the
    /// first part of the path of everything else that the page gets.
    Access(std::uint16_t port, std::string key, std::string read_key);

    [[nodiscard]] Verdict judge(const Request& request) const;

    /// "127.0.0.1:PORT"
    [[nodiscard]] const std::string& host() const { return host_; }
    /// "localhost:PORT"
    [[nodiscard]] const std::string& local_name() const { return local_name_; }
    /// The path with the key: "/?key=..."
    [[nodiscard]] std::string key_path() const { return "/?key=" + key_; }
    /// The page, with both keys behind "#", which a browser sends to nobody.
    [[nodiscard]] std::string page_with_keys() const;
    /// The path of an allowed request without the key in it: "/film/1.mp4".
    [[nodiscard]] std::string_view path_behind_key(std::string_view target) const;

  private:
    [[nodiscard]] bool is_own_host(const Request& request) const;
    [[nodiscard]] bool brings_key(const Request& request) const;
    [[nodiscard]] bool names_key(const Request& request) const;
    [[nodiscard]] bool has_read_key(std::string_view target) const;
    [[nodiscard]] Verdict judge_right(const Request& request) const;

    std::string key_;
    std::string read_key_;
    std::string host_;
    std::string local_name_;
};

}  // namespace carom::server
