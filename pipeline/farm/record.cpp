#include "pipeline/farm/record.h"

#include <cerrno>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <system_error>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "core/atomic_file.h"
#include "core/error.h"

namespace carom::farm {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kLongest = 1 << 20;  // bytes of a record

/// Others may have written the file: a pipe would never end.
std::optional<std::string> text_of_file(const std::string& path) {
    std::error_code failure;
    const fs::file_status status = fs::status(path, failure);
    if (status.type() == fs::file_type::not_found) {
        return std::nullopt;
    }
    if (failure) {
        throw Error("'" + path + "' cannot be read: " + failure.message());
    }
    const std::uintmax_t size = fs::is_regular_file(status) ? fs::file_size(path, failure) : 0;
    if (!fs::is_regular_file(status) || size > kLongest) {
        throw Error("'" + path + "' is no record");
    }
    std::ifstream file(path, std::ios::binary);
    if (!file) {
        throw Error("'" + path + "' cannot be read: " + std::generic_category().message(errno));
    }
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

}  // namespace

std::optional<Record> Record::read(const std::string& path) {
    const std::optional<std::string> text = text_of_file(path);
    return text ? std::optional(parse(*text, path)) : std::nullopt;
}

Record Record::parse(const std::string& text, const std::string& path) {
    const auto root = nlohmann::json::parse(text, nullptr, false);
    if (!root.is_object()) {
        throw Error("'" + path + "' is no JSON object");
    }
    Record record;
    record.path_ = path;
    for (const auto& [name, value] : root.items()) {
        if (value.is_structured()) {
            throw Error(fmt::format("'{}': '{}' is neither a text nor a number", path, name));
        }
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
