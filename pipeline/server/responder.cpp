#include "pipeline/server/responder.h"

#include <cctype>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include "pipeline/server/byte_range.h"
#include "pipeline/server/secret.h"

namespace carom::server {

namespace {

/// Whether the path has only ordinary characters and parts, so that it names the same thing
/// wherever it is looked up.
bool is_plain_path(std::string_view path) {
    char before = '\0';
    for (const char c : path) {
        const bool is_word =
            std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_';
        if (!is_word && c != '/' && c != '.') {
            return false;
        }
        if (before == '/' && !is_word) {
            return false;
        }
        before = c;
    }
    return path.starts_with('/') && before != '/';
}

void replace_all(std::string& text, std::string_view from, const std::string& to) {
    for (std::size_t at = text.find(from); at != std::string::npos;
         at = text.find(from, at + to.size())) {
        text.replace(at, from.size(), to);
    }
}

AnswerParts not_found() {
    AnswerParts parts = refusal(404, "Nothing is here.");
    parts.keeps_connection = true;
    return parts;
}

std::optional<Body> body_of(const Resource& resource) {
    return resource.bytes ? Body(resource.bytes) : Body::open(resource.path);
}

/// Selects the part that is asked for.
AnswerParts answer_with(const std::string& type, Body body, std::string_view range_field) {
    const std::uint64_t size = body.whole_size();
    const AskedRange asked = asked_range(range_field, size);
    if (asked.kind == RangeKind::outside) {
        AnswerParts parts = refusal(416, "The resource has no such bytes.");
        parts.fields.emplace_back("Content-Range", "bytes */" + std::to_string(size));
        parts.keeps_connection = true;
        return parts;
    }
    AnswerParts parts;
    parts.type = type;
    parts.fields.emplace_back("Accept-Ranges", "bytes");
    if (asked.kind == RangeKind::part) {
        parts.status = 206;
        parts.fields.emplace_back("Content-Range", "bytes " + std::to_string(asked.range.begin) +
                                                       "-" + std::to_string(asked.range.end - 1) +
                                                       "/" + std::to_string(size));
        body.select(asked.range);
    }
    parts.body = std::move(body);
    parts.keeps_connection = true;
    return parts;
}

AnswerParts serve(const Resource& resource, const Request& request) {
    std::optional<Body> body = body_of(resource);
    return body ? answer_with(resource.type, std::move(*body), request.value("range"))
                : not_found();
}

/// The target without its query.
std::string_view path_of(std::string_view target) {
    return target.substr(0, target.find('?'));
}

}  // namespace

Responder::Responder(std::uint16_t port, std::map<std::string, Resource> files, Site& site)
    : access_(port, make_secret(), make_secret()),
      nonce_(make_secret()),
      files_(std::move(files)),
      site_(site) {
    for (auto& [path, resource] : files_) {
        if (resource.bytes && resource.type.starts_with("text/html")) {
            std::string text = *resource.bytes;
            replace_all(text, kNoncePlaceholder, nonce_);
            resource.bytes = std::make_shared<const std::string>(std::move(text));
        }
    }
}

bool Responder::may_open_socket(const Request& request) const {
    return request.is_upgrade && request.target == kSocketPath &&
           access_.judge(request) == Verdict::allowed;
}

Answer Responder::refuse(int status, const std::string& sentence) const {
    return make_answer(refusal(status, sentence), access_.host(), nonce_);
}

Answer Responder::answer(const Request& request) {
    AnswerParts parts = answer_parts(request);
    parts.keeps_connection = parts.keeps_connection && request.keeps_connection;
    parts.without_body = request.method == "HEAD";
    const bool is_local_name = request.value("host").starts_with("localhost:");
    return make_answer(std::move(parts), is_local_name ? access_.local_name() : access_.host(),
                       nonce_);
}

AnswerParts Responder::answer_parts(const Request& request) {
    switch (access_.judge(request)) {
        case Verdict::allowed:
            return serve_resource(request);
        case Verdict::page_file:
            return serve_page_file(request);
        case Verdict::welcome:
            return welcome();
        case Verdict::foreign_host:
            return refusal(403, "This server is not known by that name.");
        case Verdict::foreign_origin:
            return refusal(403, "Only its own page may use this server.");
        case Verdict::unknown_client:
            return refusal(401, "Open the address that the program printed when it started.");
        case Verdict::wrong_method: {
            AnswerParts parts = refusal(405, "Only GET and HEAD are possible.");
            parts.fields.emplace_back("Allow", "GET, HEAD");
            return parts;
        }
        case Verdict::has_body:
            return refusal(413, "A request must not have a body.");
        case Verdict::not_understood:
            break;
    }
    return refusal(400, "The request is not understood.");
}

AnswerParts Responder::welcome() const {
    // The page takes the keys out of its address bar, and keeps them
    // (studio/src/connection/key.ts).
    AnswerParts parts;
    parts.type = "text/html; charset=utf-8";
    parts.body = Body(std::make_shared<const std::string>(
        "<!DOCTYPE html><link rel=icon href='data:,'>"  // else the browser asks for /favicon.ico
        "<meta http-equiv=refresh content='0;url=" +
        access_.page_with_keys() + "'>\n"));
    parts.keeps_connection = true;
    return parts;
}

AnswerParts Responder::serve_page_file(const Request& request) const {
    const std::string_view path = path_of(request.target).substr(kPageFolder.size() - 1);
    const auto file = files_.find(std::string(path));
    return file == files_.end() ? not_found() : serve(file->second, request);
}

AnswerParts Responder::serve_resource(const Request& request) {
    const std::string_view path = path_of(access_.path_behind_key(request.target));
    const std::optional<Resource> resource =
        request.target != kSocketPath && is_plain_path(path) ? site_.find(path) : std::nullopt;
    return resource ? serve(*resource, request) : not_found();
}

}  // namespace carom::server
