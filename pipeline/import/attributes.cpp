#include "pipeline/import/attributes.h"

#include <charconv>
#include <cmath>
#include <utility>

#include <fmt/core.h>

#include "pipeline/config/show_quantity.h"
#include "pipeline/config/text.h"

namespace carom::pipeline::scene_text {

namespace {

using config::quote;

std::string describe(const Item& item) {
    return item.is_group ? "a block in braces" : quote(item.word);
}

std::string describe(const Limits& limits) {
    const std::string kind = limits.is_whole ? "a whole number" : "a number";
    std::string range;
    if (limits.low > -1e9 && limits.high < 1e9) {
        range = std::string(limits.above_low ? " above " : " from ") + config::show(limits.low) +
                (limits.above_low ? " and up to " : " to ") + config::show(limits.high);
    } else if (limits.low > -1e9) {
        range =
            std::string(limits.above_low ? " above " : " of at least ") + config::show(limits.low);
    }
    return kind + range + (limits.can_be_default ? ", or -1 for the default" : "");
}

bool is_within(double value, const Limits& limits) {
    return (limits.above_low ? value > limits.low : value >= limits.low) && value <= limits.high &&
           (!limits.is_whole || value == std::floor(value));
}

}  // namespace

std::optional<double> to_number(const std::string& word) {
    const char* begin = word.data();
    const char* end = begin + word.size();
    begin += !word.empty() && word[0] == '+' ? 1 : 0;
    double value = 0;
    const auto [rest, error] = std::from_chars(begin, end, value);
    if (error != std::errc() || rest != end || !std::isfinite(value)) {
        return std::nullopt;
    }
    return value;
}

Attributes& Attributes::real(std::string name, Real& field, Limits limits) {
    Attribute attribute{{std::move(name)}, Kind::real};
    attribute.limits = limits;
    attribute.store_real = [&field](double value) { field = value; };
    table_.push_back(std::move(attribute));
    return *this;
}

Attributes& Attributes::vector(std::string name, std::optional<Vec3>& field) {
    Attribute attribute{{std::move(name)}, Kind::vector};
    attribute.store_vector = [&field](const Vec3& value) { field = value; };
    table_.push_back(std::move(attribute));
    return *this;
}

Attributes& Attributes::points(std::string name, std::vector<Vec3>& field) {
    Attribute attribute{{std::move(name)}, Kind::vector, true};
    attribute.store_vector = [&field](const Vec3& value) { field.push_back(value); };
    table_.push_back(std::move(attribute));
    return *this;
}

Attributes& Attributes::word(std::string name, std::optional<Name>& field) {
    Attribute attribute{{std::move(name)}, Kind::word};
    attribute.store_item = [&field](const Item& item) { field = Name{item.word, item.place}; };
    table_.push_back(std::move(attribute));
    return *this;
}

Attributes& Attributes::blocks(std::string name, std::function<void(const Item&)> read) {
    Attribute attribute{{std::move(name)}, Kind::block, true};
    attribute.store_item = std::move(read);
    table_.push_back(std::move(attribute));
    return *this;
}

Attributes& Attributes::also(std::string spelling) {
    table_.back().spellings.push_back(std::move(spelling));
    return *this;
}

Attributes& Attributes::required() {
    table_.back().is_required = true;
    return *this;
}

Attributes::Attribute* Attributes::find(const std::string& word) {
    for (Attribute& attribute : table_) {
        for (const std::string& spelling : attribute.spellings) {
            if (spelling == word) {
                return &attribute;
            }
        }
    }
    return nullptr;
}

void Attributes::read(const std::vector<Item>& items, const config::Place& place) {
    std::size_t at = 0;
    while (at < items.size()) {
        const Item& name = items[at];
        if (name.is_group) {
            problems_->error(name.place,
                             "a block in " + owner_ + " has no attribute name before it");
            ++at;
            continue;
        }
        Attribute* attribute = find(name.word);
        if (attribute == nullptr) {
            at = unknown(items, at);
            continue;
        }
        if (attribute->count++ > 0 && !attribute->repeats) {
            problems_->error(name.place, quote(name.word) + " is given twice in " + owner_);
        }
        if (at + 1 == items.size()) {
            problems_->error(name.place, quote(name.word) + " of " + owner_ + " has no value");
            break;
        }
        value(*attribute, name, items[at + 1]);
        at += 2;
    }
    for (const Attribute& attribute : table_) {
        if (attribute.is_required && attribute.count == 0) {
            problems_->error(place, owner_ + " needs " + quote(attribute.spellings.front()));
        }
    }
}

// Reports the unknown attribute and returns the index after it and its apparent value.
std::size_t Attributes::unknown(const std::vector<Item>& items, std::size_t at) {
    std::vector<std::string> known;
    for (const Attribute& attribute : table_) {
        known.push_back(attribute.spellings.front());
    }
    problems_->error(items[at].place, "unknown attribute " + quote(items[at].word) + " in " +
                                          owner_ + config::hint(items[at].word, known));
    ++at;
    const bool has_value =
        at < items.size() && (items[at].is_group || find(items[at].word) == nullptr);
    return has_value ? at + 1 : at;
}

void Attributes::value(Attribute& attribute, const Item& name, const Item& value) {
    switch (attribute.kind) {
        case Kind::real:
            number(attribute, name, value);
            break;
        case Kind::vector:
            triple(attribute, name, value);
            break;
        case Kind::word:
            if (value.is_group) {
                problems_->error(value.place, quote(name.word) + " of " + owner_ +
                                                  " must be a name, not " + describe(value));
            } else {
                attribute.store_item(value);
            }
            break;
        case Kind::block:
            if (!value.is_group) {
                problems_->error(value.place, quote(name.word) + " of " + owner_ +
                                                  " must be a block in braces, not " +
                                                  describe(value));
            } else {
                attribute.store_item(value);
            }
            break;
    }
}

void Attributes::number(Attribute& attribute, const Item& name, const Item& value) {
    const std::optional<double> number = value.is_group ? std::nullopt : to_number(value.word);
    const bool is_default = attribute.limits.can_be_default && number && *number == -1;
    if (is_default) {
        return;
    }
    if (!number || !is_within(*number, attribute.limits)) {
        problems_->error(value.place, quote(name.word) + " of " + owner_ + " must be " +
                                          describe(attribute.limits) + ", not " + describe(value));
        return;
    }
    attribute.store_real(*number);
}

void Attributes::triple(Attribute& attribute, const Item& name, const Item& value) {
    const auto refuse = [&](const Item& item, const std::string& what) {
        problems_->error(item.place, quote(name.word) + " of " + owner_ +
                                         " must be three numbers in braces, not " + what);
    };
    if (!value.is_group) {
        refuse(value, describe(value));
        return;
    }
    if (value.group.size() != 3) {
        refuse(value, fmt::format("{}", value.group.size()));
        return;
    }
    Vec3 vector;
    for (int axis = 0; axis < 3; ++axis) {
        const Item& item = value.group[static_cast<std::size_t>(axis)];
        const std::optional<double> number = item.is_group ? std::nullopt : to_number(item.word);
        if (!number || std::abs(*number) > 1e9) {
            refuse(item, describe(item));
            return;
        }
        vector[axis] = *number;
    }
    attribute.store_vector(vector);
}

}  // namespace carom::pipeline::scene_text
