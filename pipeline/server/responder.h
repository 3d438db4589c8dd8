// Finds the answer to a request: access first, then the fixed files, then the site's resources.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "pipeline/server/access.h"
#include "pipeline/server/answer.h"
#include "pipeline/server/request.h"
#include "pipeline/server/server.h"

namespace carom::server {

class Responder {
  public:
    /// `files` as in ServerOptions. Throws Error if there are no random numbers.
    Responder(std::uint16_t port, std::map<std::string, Resource> files, Site& site);

    [[nodiscard]] const Access& access() const { return access_; }

    /// Whether this request may open a WebSocket.
    [[nodiscard]] bool may_open_socket(const Request& request) const;

    /// The answer to any request that does not open a WebSocket.
    [[nodiscard]] Answer answer(const Request& request);

    /// The answer to what is not a request, or comes at a bad time.
    [[nodiscard]] Answer refuse(int status, const std::string& sentence) const;

  private:
    [[nodiscard]] AnswerParts answer_parts(const Request& request);
    [[nodiscard]] AnswerParts welcome() const;
    [[nodiscard]] AnswerParts serve_page_file(const Request& request) const;
    [[nodiscard]] AnswerParts serve_resource(const Request& request);

    Access access_;
    std::string nonce_;
    std::map<std::string, Resource> files_;
    Site& site_;
};

}  // namespace carom::server
