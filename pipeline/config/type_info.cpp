#include "pipeline/config/type_info.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "core/text.h"
#include "pipeline/config/show_quantity.h"
#include "pipeline/config/text.h"

namespace carom::pipeline::config {

namespace {

std::string describe_quantity(const TypeInfo& type) {
    const DimensionInfo& dimension = info(type.dimension);
    if (type.dimension == Dimension::none) {
        return "a number";
    }
    return dimension.name + " (" + dimension.units + ")";
}

std::string plural(const TypeInfo& element) {
    switch (element.kind) {
        case TypeInfo::Kind::quantity:
            return element.dimension == Dimension::none ? "numbers"
                                                        : info(element.dimension).plural;
        case TypeInfo::Kind::integer:
            return "whole numbers";
        case TypeInfo::Kind::name:
            return "names";
        case TypeInfo::Kind::choice:
            return "words (" + enumerate(element.choices, "and") + ")";
        case TypeInfo::Kind::map:
            return "maps of keys";
        case TypeInfo::Kind::any_of: {
            // Numbers that may also be described by a map are called by what they are.
            const bool is_number = element.elements.size() == 2 &&
                                   element.elements[0].kind == TypeInfo::Kind::quantity &&
                                   element.elements[1].kind == TypeInfo::Kind::map;
            return is_number ? plural(element.elements[0]) : "values";
        }
        default:
            return "values";
    }
}

std::string describe_list(const TypeInfo& type) {
    std::string count;
    if (type.fewest == type.most) {
        count = fmt::format("{} ", type.fewest);
    } else if (type.most > 0 && type.fewest == 0) {
        count = fmt::format("at most {} ", type.most);
    } else if (type.most > 0) {
        count = fmt::format("{} to {} ", type.fewest, type.most);
    }
    return "a list of " + count + plural(type.elements.at(0));
}

std::string describe_alternatives(const TypeInfo& type) {
    std::vector<std::string> words;
    for (const TypeInfo& element : type.elements) {
        std::string word = describe(element);
        if (std::find(words.begin(), words.end(), word) == words.end()) {
            words.push_back(std::move(word));
        }
    }
    return enumerate(words, "or");
}

}  // namespace

TypeInfo::TypeInfo() = default;
TypeInfo::TypeInfo(const TypeInfo&) = default;
TypeInfo::TypeInfo(TypeInfo&&) noexcept = default;
TypeInfo& TypeInfo::operator=(const TypeInfo&) = default;
TypeInfo& TypeInfo::operator=(TypeInfo&&) noexcept = default;
TypeInfo::~TypeInfo() = default;

bool Range::contains(double value) const {
    const bool above = !low || (low_open ? value > *low : value >= *low);
    const bool below = !high || (high_open ? value < *high : value <= *high);
    return above && below;
}

std::string describe(const Range& range, Dimension dimension) {
    std::vector<std::string> words;
    if (range.low) {
        words.push_back((range.low_open ? "more than " : "at least ") +
                        show(*range.low, dimension));
    }
    if (range.high) {
        words.push_back((range.high_open ? "less than " : "at most ") +
                        show(*range.high, dimension));
    }
    return enumerate(words, "and");
}

std::string describe(const TypeInfo& type) {
    switch (type.kind) {
        case TypeInfo::Kind::boolean:
            return "true or false";
        case TypeInfo::Kind::integer:
            return "a whole number";
        case TypeInfo::Kind::quantity:
            return describe_quantity(type);
        case TypeInfo::Kind::text:
            return type.noun.empty() ? "a text" : type.noun;
        case TypeInfo::Kind::name:
            return "the name of " + type.noun;
        case TypeInfo::Kind::file:
            return "the name of a file";
        case TypeInfo::Kind::choice:
            return (type.choices.size() > 1 ? "one of " : "") + enumerate(type.choices, "and");
        case TypeInfo::Kind::list:
            return describe_list(type);
        case TypeInfo::Kind::named:
            return "a map from names to " + type.noun;
        case TypeInfo::Kind::settings:
            return "a map from key paths to values";
        case TypeInfo::Kind::map:
            return "a map of keys";
        case TypeInfo::Kind::any_of:
            return describe_alternatives(type);
    }
    return {};
}

}  // namespace carom::pipeline::config
