#include "pipeline/farm/record.h"

#include <cerrno>
#include <charconv>
#include <fstream>
#include <sstream>

#include <unistd.h>
#include <yaml-cpp/yaml.h>

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

// JSON is YAML, for flat objects without control characters at least.
std::optional<Record> Record::read(const std::string& path) {
    const std::optional<std::string> text = text_of_file(path);
    if (!text) {
        return std::nullopt;
    }
    Record record;
    record.path_ = path;
    try {
        const YAML::Node root = YAML::Load(*text);
        if (!root.IsMap()) {
            throw Error("'" + path + "' is no JSON object");
        }
        for (const auto& member : root) {
            record.members_[member.first.as<std::string>()] = member.second.as<std::string>();
        }
    } catch (const YAML::Exception& error) {
        throw Error("'" + path + "' is no JSON object: " + error.what());
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
