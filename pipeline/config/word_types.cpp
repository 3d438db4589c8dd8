#include "pipeline/config/word_types.h"

#include <algorithm>

#include "core/text.h"
#include "pipeline/config/text.h"

namespace carom::pipeline::config {

namespace {

std::string noun_of(ReferenceKind kind) {
    switch (kind) {
        case ReferenceKind::ball:
            return "a ball";
        case ReferenceKind::body:
        case ReferenceKind::simulated:
        case ReferenceKind::moving:
            return "a ball or moving object";
        case ReferenceKind::touchable:
            return "an object or surface";
        case ReferenceKind::placed:
            return "a ball or object";
        case ReferenceKind::aimed:
            return "a ball, object, spot or pocket";
        case ReferenceKind::spot:
            return "a spot of the table";
        case ReferenceKind::pocket:
            return "a pocket of the table";
        case ReferenceKind::material:
            return "a material";
    }
    return {};
}

}  // namespace

ValueType<bool> boolean() {
    ValueType<bool> result;
    result.info.kind = TypeInfo::Kind::boolean;
    const TypeInfo type = result.info;
    result.read = [type](Reader& reader, const Node& node) -> std::optional<bool> {
        // The core schema of YAML 1.2 (section 10.3.2) does not have yes, no, on and off.
        const bool is_plain = node.is_scalar() && !node.quoted;
        if (is_plain && (node.text == "true" || node.text == "True" || node.text == "TRUE")) {
            return true;
        }
        if (is_plain && (node.text == "false" || node.text == "False" || node.text == "FALSE")) {
            return false;
        }
        reader.wrong_type(node, describe(type));
        return std::nullopt;
    };
    result.show = [](const bool& value) { return value ? "true" : "false"; };
    return result;
}

namespace {

ValueType<std::string> text_of_type(TypeInfo type) {
    ValueType<std::string> result;
    result.info = type;
    result.read = [type = std::move(type)](Reader& reader,
                                           const Node& node) -> std::optional<std::string> {
        if (!node.is_scalar()) {
            reader.wrong_type(node, describe(type));
            return std::nullopt;
        }
        return node.text;
    };
    result.show = [](const std::string& value) { return value; };
    return result;
}

}  // namespace

ValueType<std::string> text(std::string noun) {
    TypeInfo type;
    type.kind = TypeInfo::Kind::text;
    type.noun = std::move(noun);
    return text_of_type(std::move(type));
}

ValueType<std::string> word(std::vector<std::string> suggested, std::string more) {
    TypeInfo type;
    type.kind = TypeInfo::Kind::text;
    type.noun = "a word such as " + enumerate(suggested, "or");
    type.choices = std::move(suggested);
    type.more_choices = std::move(more);
    return text_of_type(std::move(type));
}

ValueType<std::string> name_of(ReferenceKind kind) {
    ValueType<std::string> result;
    result.info.kind = TypeInfo::Kind::name;
    result.info.noun = noun_of(kind);
    const TypeInfo type = result.info;
    result.read = [type, kind](Reader& reader, const Node& node) -> std::optional<std::string> {
        if (!node.is_scalar()) {
            reader.wrong_type(node, describe(type));
            return std::nullopt;
        }
        reader.refer(kind, node);
        return node.text;
    };
    result.show = [](const std::string& value) { return value; };
    return result;
}

ValueType<std::string> file(FileKind kind) {
    ValueType<std::string> result;
    result.info.kind = TypeInfo::Kind::file;
    const TypeInfo type = result.info;
    result.read = [type, kind](Reader& reader, const Node& node) -> std::optional<std::string> {
        if (!node.is_scalar()) {
            reader.wrong_type(node, describe(type));
            return std::nullopt;
        }
        std::string path = reader.file(node, kind);
        return path.empty() ? std::nullopt : std::optional(std::move(path));
    };
    return result;
}

std::optional<std::size_t> read_choice(Reader& reader, const Node& node, const TypeInfo& type) {
    if (!node.is_scalar()) {
        reader.wrong_type(node, describe(type));
        return std::nullopt;
    }
    const auto found = std::find(type.choices.begin(), type.choices.end(), node.text);
    if (found == type.choices.end()) {
        reader.error(node.place, reader.value_name() + " must be " + describe(type) + ", not " +
                                     quote(node.text) + hint(node.text, type.choices));
        return std::nullopt;
    }
    return static_cast<std::size_t>(found - type.choices.begin());
}

}  // namespace carom::pipeline::config
