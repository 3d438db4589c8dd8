// The texts from which a shot was read, so that every problem can show its line.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/config/problem.h"

namespace carom::pipeline::config {

/// A place in one of the texts of a SourceSet. Lines and columns count from 1; columns and lengths
/// are characters (code points), not bytes.
struct Place {
    int source = -1;  // index in the SourceSet, -1: no place
    int line = 0;
    int column = 0;
    int length = 1;

    bool operator==(const Place&) const = default;
};

/// One text: a file, a text in memory or the value of a --set.
struct SourceText {
    std::string name;     // as problems print it
    std::string folder;   // relative paths in the text refer to this folder
    std::string text;     // valid UTF-8
    Place included_at{};  // place of the include in another text; else empty
    std::string path{};   // of the file, absolute; empty: the text is not that of a file
};

class SourceSet {
  public:
    /// Adds a text and returns its index.
    int add(SourceText source);

    [[nodiscard]] const SourceText& at(int index) const { return sources_.at(index).source; }
    [[nodiscard]] int size() const { return static_cast<int>(sources_.size()); }

    /// The line of `place`, without its line end; empty without a place and for lines over 4 KiB.
    [[nodiscard]] std::string line_of(const Place& place) const;

    /// The place with the name of the text instead of its index.
    [[nodiscard]] SourcePlace describe(const Place& place) const;

    /// The place that includes the text of `place`, the place that includes the including text, and
    /// so on. An option such as "--quality" has no line.
    [[nodiscard]] std::vector<SourcePlace> include_chain(const Place& place) const;

    /// "shot.yaml:14:9"
    [[nodiscard]] std::string to_string(const Place& place) const;

    /// The place of byte `offset` of text `index`, `length_bytes` long (cut at the line's end).
    [[nodiscard]] Place place_at(int index, std::size_t offset, std::size_t length_bytes) const;

    /// The offset of a line and a column in bytes, both counted from 0.
    [[nodiscard]] std::size_t offset_of(int index, int line, int column_bytes) const;

  private:
    struct Entry {
        SourceText source;
        std::vector<std::size_t> line_starts;
    };
    [[nodiscard]] std::string_view line_text(const Entry& entry, std::size_t line) const;

    std::vector<Entry> sources_;
};

/// The number of code points of valid UTF-8.
[[nodiscard]] int character_count(std::string_view text);

}  // namespace carom::pipeline::config
