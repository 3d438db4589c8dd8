#include "pipeline/import/track_table.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <span>

#include <fmt/core.h>

#include "core/text.h"
#include "pipeline/config/show_quantity.h"
#include "pipeline/config/text.h"
#include "pipeline/import/csv_lines.h"

namespace carom::pipeline {

namespace {

using config::Place;
using config::quote;

constexpr double kLongest = 3600;   // s, the same limit as for the keys of a motion
constexpr double kFarthest = 1e5;   // m
constexpr double kShortest = 1e-6;  // s, between two keys

/// Columns that must be given together.
struct Group {
    std::vector<std::string> names;
    bool is_required = false;
};

const std::array<Group, 6>& groups() {
    static const std::array<Group, 6> list{{{{"time"}, true},
                                            {{"x", "y", "z"}, true},
                                            {{"qw", "qx", "qy", "qz"}},
                                            {{"rx", "ry", "rz"}},
                                            {{"vx", "vy", "vz"}},
                                            {{"wx", "wy", "wz"}}}};
    return list;
}

std::string lower(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) {
        return c < 0x80 ? static_cast<char>(std::tolower(c)) : static_cast<char>(c);
    });
    return text;
}

class TableReader {
  public:
    TableReader(const CsvTable& table, std::string object, config::ProblemList& problems)
        : lines_(table.lines),
          separator_(table.separator),
          object_(std::move(object)),
          problems_(problems) {}

    std::vector<TrackRow> read(int source) {
        if (lines_.empty()) {
            problems_.error({source, 1, 1, 1},
                            "the table is empty: it needs a first line that names its "
                            "columns, and one line for each time");
            return {};
        }
        read_header();
        if (!problems_.has_error()) {
            check_object();
        }
        if (problems_.has_error()) {
            return {};  // later problems would concern the wrong columns or rows
        }
        find_decimal_comma();
        std::vector<TrackRow> rows;
        for (const CsvLine& line : std::span(lines_).subspan(1)) {
            if (std::optional<TrackRow> row = read_row(line)) {
                check_time(rows, *row);
                rows.push_back(*row);
            }
        }
        if (rows.size() < 2 && !problems_.has_error()) {
            problems_.error(lines_.back().place, "the table needs at least two rows for a motion");
        }
        return rows;
    }

  private:
    void read_header() {
        const CsvLine& header = lines_.front();
        std::vector<std::string> known{"object"};
        for (const Group& group : groups()) {
            known.insert(known.end(), group.names.begin(), group.names.end());
        }
        for (std::size_t i = 0; i < header.cells.size(); ++i) {
            const std::string name = lower(header.cells[i].text);
            if (std::ranges::find(known, name) == known.end()) {
                unknown_column(header.cells[i], known);
            } else if (!columns_.emplace(name, i).second) {
                problems_.error(header.cells[i].place, "column " + quote(name) + " is given twice");
            }
        }
        for (const Group& group : groups()) {
            check_group(group, header.place);
        }
        if (has("qw") && has("rx")) {
            problems_.error(header.cells[columns_.at("rx")].place,
                            "give either 'rx, ry, rz' or 'qw, qx, qy, qz', not both");
        }
    }

    void unknown_column(const CsvCell& cell, const std::vector<std::string>& known) {
        double ignored = 0;
        if (parse(cell.text, ignored)) {
            problems_.error(cell.place,
                            quote(cell.text) +
                                " is a number, but the first line must name the columns, "
                                "for example: time,x,y,z");
        } else {
            problems_.warning(cell.place, "column " + quote(cell.text) + " is not used" +
                                              config::hint(lower(cell.text), known));
        }
    }

    void check_group(const Group& group, const Place& header) {
        std::vector<std::string> missing;
        for (const std::string& name : group.names) {
            if (!has(name)) {
                missing.push_back("'" + name + "'");
            }
        }
        if (!missing.empty() && (group.is_required || missing.size() < group.names.size())) {
            problems_.error(header, std::string(missing.size() > 1 ? "columns " : "column ") +
                                        enumerate(missing, "and") +
                                        (missing.size() > 1 ? " are missing" : " is missing"));
        }
    }

    [[nodiscard]] bool has(const std::string& name) const { return columns_.contains(name); }

    std::optional<TrackRow> read_row(const CsvLine& line) {
        if (line.cells.size() != lines_.front().cells.size()) {
            const bool may_be_decimals =
                separator_ == ',' && line.cells.size() > lines_.front().cells.size();
            problems_.error(
                line.place,
                fmt::format("this row has {} values, but the table has {} columns{}",
                            line.cells.size(), lines_.front().cells.size(),
                            may_be_decimals ? "; if its numbers have decimal commas, separate the "
                                              "columns with semicolons"
                                            : ""));
            return std::nullopt;
        }
        if (has("object")) {
            const std::string& name = line.cells[columns_.at("object")].text;
            if (!object_.empty() && name != object_) {
                return std::nullopt;
            }
        }
        is_valid_ = true;
        TrackRow row;
        row.place = line.place;
        row.time = number(line, "time", 0, kLongest, "s");
        row.position = vector(line, {"x", "y", "z"}, kFarthest, "m");
        if (has("qw")) {
            row.rotate = rotation(line);
        }
        if (has("rx")) {
            row.angles =
                vector(line, {"rx", "ry", "rz"}, 1e6, "degrees") * (std::numbers::pi / 180);
        }
        if (has("vx")) {
            row.velocity = vector(line, {"vx", "vy", "vz"}, kFarthest, "m/s");
        }
        if (has("wx")) {
            row.spin = vector(line, {"wx", "wy", "wz"}, 1e6, "rad/s");
        }
        return is_valid_ ? std::optional(row) : std::nullopt;
    }

    Vec3 vector(const CsvLine& line, const std::array<const char*, 3>& names, double most,
                const char* unit) {
        Vec3 result(0, 0, 0);
        for (std::size_t i = 0; i < 3; ++i) {
            result[static_cast<int>(i)] = number(line, names[i], -most, most, unit);
        }
        return result;
    }

    Quat rotation(const CsvLine& line) {
        const double w = number(line, "qw", -2, 2, nullptr);
        const double x = number(line, "qx", -2, 2, nullptr);
        const double y = number(line, "qy", -2, 2, nullptr);
        const double z = number(line, "qz", -2, 2, nullptr);
        const Quat q(w, Vec3(x, y, z));
        const double length = q.length();
        if (is_valid_ && !(std::abs(length - 1) < 0.01)) {
            problems_.error(line.cells[columns_.at("qw")].place,
                            "the quaternion qw, qx, qy, qz has length " + config::show(length) +
                                ", but must have length 1");
            is_valid_ = false;
            return {};
        }
        return q.normalized();
    }

    double number(const CsvLine& line, const char* name, double least, double most,
                  const char* unit) {
        const CsvCell& cell = line.cells[columns_.at(name)];
        double value = 0;
        if (const std::string problem = read_number(cell.text, value); !problem.empty()) {
            problems_.error(cell.place, std::string("'") + name + "' " + problem);
            is_valid_ = false;
        } else if (!(value >= least && value <= most)) {
            problems_.error(cell.place, std::string("'") + name + "' must lie between " +
                                            config::show(least) + " and " + config::show(most) +
                                            (unit != nullptr ? std::string(" ") + unit : ""));
            is_valid_ = false;
        }
        return value;
    }

    /// Whether the numbers of the table have decimal commas: whether one has a comma that cannot
    /// stand before thousands. Where commas separate columns, "1,234" can.
    void find_decimal_comma() {
        for (const CsvLine& line : std::span(lines_).subspan(1)) {
            for (const auto& [name, column] : columns_) {
                if (name == "object" || column >= line.cells.size()) {
                    continue;
                }
                const std::string& text = line.cells[column].text;
                const std::size_t comma = text.find(',');
                const bool can_be_thousands = separator_ == ',' && text.size() == comma + 4;
                double value = 0;
                if (comma != std::string::npos && !can_be_thousands &&
                    parse(with_point(text), value)) {
                    line_of_comma_ = line.place.line;
                    return;
                }
            }
        }
    }

    static std::string with_point(std::string text) {
        std::ranges::replace(text, ',', '.');
        return text;
    }

    /// The rest of a sentence about what is wrong with a number; empty if it was read.
    [[nodiscard]] std::string read_number(const std::string& text, double& value) const {
        const bool has_comma = text.find(',') != std::string::npos;
        const bool has_point = text.find('.') != std::string::npos;
        if (text.empty()) {
            return "has no value";
        }
        if (line_of_comma_ > 0 && has_point && !has_comma && parse(text, value)) {
            return fmt::format(
                "has a point in {}, but numbers of this table have decimal commas "
                "(line {})",
                quote(text), line_of_comma_);
        }
        if (line_of_comma_ > 0 ? parse(with_point(text), value) && !(has_point && has_comma)
                               : parse(text, value)) {
            return {};
        }
        std::string digits;  // without what separates thousands, if that is all that is wrong
        for (std::size_t at = 0; at < text.size(); ++at) {
            const bool is_wide = text.compare(at, 2, "\xc2\xa0") == 0;       // no-break space
            const bool is_wider = text.compare(at, 3, "\xe2\x80\xaf") == 0;  // the narrow one
            if (is_wide || is_wider) {
                at += is_wide ? 1 : 2;
            } else if (std::string_view(",.' ").find(text[at]) == std::string_view::npos) {
                digits += text[at];
            }
        }
        return std::string("must be a number") +
               (parse(digits, value) ? " without thousands separators" : "") + ", not " +
               quote(text);
    }

    static bool parse(const std::string& text, double& value) {
        const char* begin = text.data() + (text.starts_with('+') ? 1 : 0);
        const char* end = text.data() + text.size();
        const auto [rest, error] = std::from_chars(begin, end, value);
        return error == std::errc() && rest == end && std::isfinite(value);
    }

    void check_time(const std::vector<TrackRow>& rows, const TrackRow& row) {
        if (rows.empty() || row.time >= rows.back().time + kShortest) {
            return;
        }
        const TrackRow& last = rows.back();
        const bool is_jump = row.time == last.time && row.velocity &&
                             row.position == last.position &&
                             (rows.size() < 2 || rows[rows.size() - 2].time < last.time);
        if (!is_jump) {
            problems_.error(
                row.place,
                fmt::format("time {} s is not later than the {} s of line {}",
                            config::show(row.time), config::show(last.time), last.place.line));
        }
    }

    void check_object() {
        const Place& place = lines_.front().place;
        if (!has("object")) {
            if (!object_.empty()) {
                problems_.error(place, "cannot select object " + quote(object_) +
                                           ": the table has no column 'object'");
            }
            return;
        }
        std::set<std::string> found;
        for (const CsvLine& line : std::span(lines_).subspan(1)) {
            if (line.cells.size() > columns_.at("object")) {
                found.insert(line.cells[columns_.at("object")].text);
            }
        }
        const std::vector<std::string> names(found.begin(), found.end());
        if (!object_.empty() && !found.contains(object_)) {
            problems_.error(
                place, "the table has no object " + quote(object_) + config::hint(object_, names));
        } else if (object_.empty() && names.size() > 1) {
            problems_.error(lines_.front().cells[columns_.at("object")].place,
                            "the table has several objects; choose one with --object: " +
                                enumerate(names, "or"));
        }
    }

    const std::vector<CsvLine>& lines_;
    char separator_;
    int line_of_comma_ = 0;  // of a number with a decimal comma; 0: there is none
    std::string object_;
    config::ProblemList& problems_;
    std::map<std::string, std::size_t, std::less<>> columns_;
    bool is_valid_ = true;  // whether all values of the current row are valid
};

}  // namespace

std::vector<TrackRow> read_track_table(const config::SourceSet& sources, int source,
                                       const std::string& object, config::ProblemList& problems) {
    const CsvTable table = csv_table(sources, source);
    return TableReader(table, object, problems).read(source);
}

}  // namespace carom::pipeline
