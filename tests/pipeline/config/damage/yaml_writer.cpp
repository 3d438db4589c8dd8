#include "tests/pipeline/config/damage/yaml_writer.h"

#include <algorithm>

namespace carom::testing {

Yaml Yaml::free_text(std::string scalar) {
    Yaml value(std::move(scalar));
    value.is_text = true;
    return value;
}

Yaml Yaml::list(std::vector<Yaml> items) {
    Yaml value;
    value.kind = Kind::list;
    value.items = std::move(items);
    return value;
}

Yaml& Yaml::add(std::string key, Yaml value) {
    entries.emplace_back(std::move(key), std::move(value));
    return *this;
}

bool Yaml::holds_map() const {
    return kind == Kind::map ||
           std::any_of(items.begin(), items.end(), [](const Yaml& y) { return y.holds_map(); });
}

namespace {

class Writer {
  public:
    explicit Writer(Dice& dice)
        : dice_(dice), step_(1 + dice.below(4)), dashes_are_indented_(dice.chance(0.7)) {}

    std::string text(const Yaml& map) && {
        write_map(map, 0, "");
        return std::move(text_);
    }

  private:
    std::string scalar(const Yaml& value) {
        if (value.text == "true" || value.text == "false") {
            return value.text;  // in quotes it would be a text
        }
        const double fraction = value.text.starts_with('\'') ? 0 : value.is_text ? 0.5 : 0.03;
        if (!dice_.chance(fraction)) {
            return value.text;
        }
        const char quote = dice_.chance(0.5) ? '\'' : '"';
        return quote + value.text + quote;
    }

    /// Writes in flow style, sometimes on several lines that are indented by `indent`.
    std::string flow(const Yaml& value, int indent) {
        if (value.kind == Yaml::Kind::scalar) {
            return scalar(value);
        }
        const bool is_list = value.kind == Yaml::Kind::list;
        std::string text(1, is_list ? '[' : '{');
        const std::size_t count = is_list ? value.items.size() : value.entries.size();
        for (std::size_t i = 0; i < count; ++i) {
            if (i > 0) {
                text += dice_.chance(0.1) ? ",\n" + std::string(indent, ' ') : std::string(", ");
            }
            text += is_list ? flow(value.items[i], indent)
                            : value.entries[i].first + ": " + flow(value.entries[i].second, indent);
        }
        return text + (is_list ? ']' : '}');
    }

    void end_line() {
        text_ += dice_.chance(0.05) ? "  # it's so\n" : "\n";
        if (dice_.chance(0.03)) {
            text_ += dice_.chance(0.5) ? "\n" : "# a comment: {\"\n";
        }
    }

    /// Writes the value after "key:" or "-".
    void write_value(const Yaml& value, int indent) {
        const bool as_block = indent <= 2 * step_
                                  ? value.holds_map() && dice_.chance(indent == 0 ? 0.95 : 0.6)
                                  : value.kind == Yaml::Kind::map && dice_.chance(0.2);
        if (as_block && value.kind == Yaml::Kind::map && !value.entries.empty()) {
            end_line();
            write_map(value, indent + step_, std::string(indent + step_, ' '));
        } else if (as_block && value.kind == Yaml::Kind::list) {
            end_line();
            write_list(value, indent + (dashes_are_indented_ ? step_ : 0));
        } else {
            text_ += " " + flow(value, indent + step_ + 2);
            end_line();
        }
    }

    /// The first line begins with `first`, the others with `indent` spaces.
    void write_map(const Yaml& map, int indent, std::string first) {
        for (const auto& [key, value] : map.entries) {
            text_ += first + key + ":";
            first = std::string(indent, ' ');
            write_value(value, indent);
        }
    }

    void write_list(const Yaml& list, int indent) {
        const std::string dash = std::string(indent, ' ') + "- ";
        for (const Yaml& item : list.items) {
            if (item.kind == Yaml::Kind::map && dice_.chance(0.6)) {
                write_map(item, indent + 2, dash);
            } else {
                text_ += dash + flow(item, indent + 4);
                end_line();
            }
        }
    }

    Dice& dice_;
    int step_;
    bool dashes_are_indented_;
    std::string text_;
};

}  // namespace

std::string write_yaml(const Yaml& map, Dice& dice) {
    return Writer(dice).text(map);
}

}  // namespace carom::testing
