#include "pipeline/farm/record.h"

#include <cerrno>
#include <charconv>
#include <fstream>
#include <sstream>

#include <nlohmann/json.hpp>
#include <unistd.h>

#include "core/atomic_file.h"
#include "core/error.h"

namespace carom::farm {
namespace {

std::optional<std::string> text_of_file(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) {
        if (::access(path.c_str(), F_OK) != 0 && errno == ENOENT) {
            return std::nullopt;
        }
        throw Error("'" + path + "' cannot be read");
    }
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

}  // namespace

std::optional<Record> Record::read(const std::string& path) {
    const std::optional<std::string> text = text_of_file(path);
    if (!text) {
        return std::nullopt;
    }
    const auto root = nlohmann::json::parse(*text, nullptr, false);
    if (!root.is_object()) {
        throw Error("'" + path + "' is no JSON object");
    }
    Record record;
    record.path_ = path;
    for (const auto& [name, value] : root.items()) {
        record.members_[name] = value.is_string() ? value.get<std::string>() : value.dump();
    }
    return record;
}

std::string Record::text(const std::string& name) const {
    const auto found = members_.find(name);
    return found == members_.end() ? std::string() : found->second;
}

std::int64_t Record::integer(const std::string& name) const {
    const std::string digits = text(name);
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (!digits.empty() && (error != std::errc() || end != digits.data() + digits.size())) {
        fail(name);
    }
    return value;
}

double Record::number(const std::string& name) const {
    const std::string digits = text(name);
    double value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (!digits.empty() && (error != std::errc() || end != digits.data() + digits.size())) {
        fail(name);
    }
    return value;
}

void Record::fail(const std::string& name) const {
    throw Error("'" + path_ + "': '" + name + "' is no number: " + text(name));
}

void write_record(const std::string& path, const JsonMembers& members) {
    const std::string text = members.object() + "\n";
    write_file_atomically(path, std::as_bytes(std::span(text)));
}

}  // namespace carom::farm
