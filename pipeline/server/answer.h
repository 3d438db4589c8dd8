// Answers to HTTP requests.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "pipeline/server/body.h"

namespace carom::server {

struct Answer {
    std::string head;  // status line and all fields, up to and with the empty line
    Body body;         // what is to be sent after it: nothing for HEAD
    bool keeps_connection = false;
};

/// An answer before its head is written.
struct AnswerParts {
    int status = 200;
    std::string type = "text/plain; charset=utf-8";
    std::vector<std::pair<std::string, std::string>> fields;  // besides those of every answer
    Body body;
    bool keeps_connection = false;
    bool without_body = false;  // HEAD: the fields of the answer, without its body
};

/// Writes the head: status, length and the fields of every answer, which tell a browser to run no
/// foreign scripts in the page, to load nothing from elsewhere, and to let no other page embed,
/// read or keep what is served. `host` is the one that was asked, `nonce` the one of the page.
[[nodiscard]] Answer make_answer(AnswerParts parts, const std::string& host,
                                 const std::string& nonce);

/// An answer with a sentence as its body, after which the connection ends.
[[nodiscard]] AnswerParts refusal(int status, const std::string& sentence);

}  // namespace carom::server
