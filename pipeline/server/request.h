// The head of an HTTP request, as plain data.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace carom::server {

struct Request {
    std::string method;                                       // "GET"
    std::string target;                                       // "/path?query"
    std::vector<std::pair<std::string, std::string>> fields;  // names in lower case; in order
    bool is_upgrade = false;                                  // to a WebSocket
    bool keeps_connection = true;

    /// How often a field occurs. `name` is in lower case.
    [[nodiscard]] std::size_t count(std::string_view name) const {
        return static_cast<std::size_t>(std::count_if(
            fields.begin(), fields.end(), [&](const auto& field) { return field.first == name; }));
    }
    /// The value of the first such field; empty if there is none.
    [[nodiscard]] std::string_view value(std::string_view name) const {
        const auto found = std::find_if(fields.begin(), fields.end(),
                                        [&](const auto& field) { return field.first == name; });
        return found == fields.end() ? std::string_view() : std::string_view(found->second);
    }
};

}  // namespace carom::server
