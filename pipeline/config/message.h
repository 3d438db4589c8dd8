// The sentence of a problem.
#pragma once

#include <string>
#include <utility>

namespace carom::pipeline::config {

/// A text alone converts to a message without a suggestion.
struct Message {
    std::string text;
    std::string suggestion;  // the name that the text suggests ("position"), or empty

    Message(std::string sentence = {}, std::string meant = {})
        : text(std::move(sentence)), suggestion(std::move(meant)) {}
    Message(const char* sentence) : text(sentence) {}
};

/// The message with a prefix.
inline Message operator+(const std::string& before, const Message& message) {
    return {before + message.text, message.suggestion};
}

}  // namespace carom::pipeline::config
