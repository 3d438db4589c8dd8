#include "pipeline/server/answer.h"

#include <memory>

#include "core/assert.h"

namespace carom::server {

namespace {

const char* reason_of(int status) {
    switch (status) {
        case 200:
            return "OK";
        case 206:
            return "Partial Content";
        case 400:
            return "Bad Request";
        case 401:
            return "Unauthorized";
        case 403:
            return "Forbidden";
        case 404:
            return "Not Found";
        case 405:
            return "Method Not Allowed";
        case 413:
            return "Content Too Large";
        case 416:
            return "Range Not Satisfiable";
        case 431:
            return "Request Header Fields Too Large";
        case 503:
            return "Service Unavailable";
        default:
            return "Unknown";
    }
}

/// The Content-Security-Policy. Style elements need the nonce (CodeMirror adds some). Scripts,
/// fonts and connections are the server's own; 'self' does not mean ws: in every browser, so that
/// is named; blob: is what the page itself made, such as a texture out of a glTF file.
std::string content_policy(const std::string& host, const std::string& nonce) {
    return "default-src 'self'; script-src 'self'; style-src 'self' 'nonce-" + nonce +
           "'; img-src 'self' blob: data:; media-src 'self' blob:; connect-src 'self' blob: ws://" +
           host +
           "; worker-src 'self' blob:; object-src 'none'; base-uri 'none'; form-action 'none'; "
           "frame-ancestors 'none'";
}

void add(std::string& head, const std::string& name, const std::string& value) {
    CAROM_ASSERT(value.find_first_of("\r\n") == std::string::npos);
    head += name + ": " + value + "\r\n";
}

}  // namespace

Answer make_answer(AnswerParts parts, const std::string& host, const std::string& nonce) {
    Answer answer;
    answer.head =
        "HTTP/1.1 " + std::to_string(parts.status) + " " + reason_of(parts.status) + "\r\n";
    add(answer.head, "Content-Type", parts.type);
    add(answer.head, "Content-Length", std::to_string(parts.body.bytes_left()));
    add(answer.head, "Content-Security-Policy", content_policy(host, nonce));
    add(answer.head, "X-Content-Type-Options", "nosniff");
    add(answer.head, "Referrer-Policy", "no-referrer");
    add(answer.head, "Cross-Origin-Resource-Policy", "same-origin");
    add(answer.head, "Cross-Origin-Opener-Policy", "same-origin");
    add(answer.head, "Cache-Control", "no-store");
    for (const auto& [name, value] : parts.fields) {
        add(answer.head, name, value);
    }
    add(answer.head, "Connection", parts.keeps_connection ? "keep-alive" : "close");
    answer.head += "\r\n";
    if (!parts.without_body) {
        answer.body = std::move(parts.body);
    }
    answer.keeps_connection = parts.keeps_connection;
    return answer;
}

AnswerParts refusal(int status, const std::string& sentence) {
    AnswerParts parts;
    parts.status = status;
    parts.body = Body(std::make_shared<const std::string>(sentence + "\n"));
    return parts;
}

}  // namespace carom::server
