// Small records in files: one flat JSON object each.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "core/json_text.h"

namespace carom::farm {

/// The members of a JSON object of texts and numbers.
class Record {
  public:
    /// Reads a file. Empty if it does not exist. Throws Error if it is not a flat JSON object.
    [[nodiscard]] static std::optional<Record> read(const std::string& path);
    /// A text from the file `path`, which errors name. Throws Error likewise.
    [[nodiscard]] static Record parse(const std::string& text, const std::string& path);

    /// Empty or 0 if there is no such member. Throws Error if it is no number.
    [[nodiscard]] std::string text(const std::string& name) const;
    [[nodiscard]] std::int64_t integer(const std::string& name) const;
    [[nodiscard]] double number(const std::string& name) const;

  private:
    [[noreturn]] void fail(const std::string& name) const;

    std::string path_;
    std::map<std::string, std::string> members_;
};

/// Writes a record completely or not at all. Throws Error.
void write_record(const std::string& path, const JsonMembers& members);

}  // namespace carom::farm
