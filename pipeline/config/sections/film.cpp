// The keys of a film of several shots.
#include <algorithm>
#include <utility>
#include <variant>

#include "pipeline/config/emit_yaml.h"
#include "pipeline/config/picture_size.h"
#include "pipeline/config/sections/sections.h"
#include "pipeline/picture/value_text.h"
#include "render/scene/scene_problems.h"

namespace carom::pipeline::config {

namespace {

constexpr double kLongest = 3600;  // s

/// Values by their key paths, each as text for --set.
ValueType<std::vector<std::string>> settings() {
    ValueType<std::vector<std::string>> result;
    result.info.kind = TypeInfo::Kind::settings;
    const TypeInfo type = result.info;
    result.read = [type](Reader& reader,
                         const Node& node) -> std::optional<std::vector<std::string>> {
        if (!node.is_map()) {
            reader.wrong_type(node, describe(type));
            return std::nullopt;
        }
        std::vector<std::string> all;
        for (const Entry& entry : node.entries) {
            all.push_back(entry.key + "=" + emit_flow(entry.value));
        }
        return all;
    };
    return result;
}

ValueType<std::array<int, 2>> picture_size() {
    return convert<std::array<int, 2>>(list_of(integer(kShortestSide, render::kLongestSide), 2, 2),
                                       [](const std::vector<int>& sides) {
                                           return std::array{sides[0], sides[1]};
                                       });
}

/// A text without a moment of which it could show values.
void warn_of_values(Reader& reader, const Entry* text) {
    const auto parsed = parse_value_text(text != nullptr ? text->value.text : "");
    const auto* pieces = std::get_if<std::vector<TextPiece>>(&parsed);
    if (pieces != nullptr && std::ranges::any_of(*pieces, [](const TextPiece& piece) {
            return std::holds_alternative<TextValue>(piece);
        })) {
        reader.warning(text->key_place,
                       "a title card shows no moment of a shot, so that values in braces say "
                       "nothing on it; write '{{' for the brace itself");
    }
}

TitleCard& card_of(FilmPartSection& part) {
    if (!part.title) {
        part.title.emplace();
    }
    return *part.title;
}

const MapSpec<FilmPartSection>& part_spec() {
    static const MapSpec<FilmPartSection> spec = [] {
        MapSpec<FilmPartSection> s("part", "A part of a film: a shot, or a title card.");
        s.key("shot", &FilmPartSection::shot, text("the name of a file"),
              "file of the shot, or its bake, relative to this file");
        s.key("set", &FilmPartSection::overrides, settings(),
              "values of the shot that are replaced, by their key paths as for `--set`: "
              "{render.samples: 64}")
            .goes_with({"shot"});
        s.key("from", &FilmPartSection::from, exact(Dimension::time, between(0, kLongest)),
              "time of the shot's own film at which the part begins. The default is its start")
            .goes_with({"shot"});
        s.key("to", &FilmPartSection::to, exact(Dimension::time, above_up_to(0, kLongest)),
              "time of the shot's own film at which the part ends. The default is its end")
            .goes_with({"shot"});
        s.set(
            "title", text_with_values("lines of text"),
            [](FilmPartSection& part, std::string text) { card_of(part).text = std::move(text); },
            "text of a title card");
        s.set(
             "subtitle", text_with_values("lines of text"),
             [](FilmPartSection& part, std::string text) {
                 card_of(part).subtitle = std::move(text);
             },
             "smaller text below the title")
            .goes_with({"title"});
        s.key("for", &FilmPartSection::length, exact(Dimension::time, above_up_to(0, kLongest)),
              "how long the title card is shown")
            .goes_with({"title"});
        s.set(
             "colour", colour(between(0, 1)),
             [](FilmPartSection& part, const Vec3& value) { card_of(part).colour = value; },
             "colour of the letters", "1")
            .goes_with({"title"});
        s.set(
             "background", colour(between(0, 1)),
             [](FilmPartSection& part, const Vec3& value) { card_of(part).background = value; },
             "colour behind them. The default is nearly black")
            .goes_with({"title"});
        s.key("fade", &FilmPartSection::fade, exact(Dimension::time, between(0, 60)),
              "time for which the part before fades into this one; both are shown then. The first "
              "part appears out of black");
        s.exactly_one_of({"shot", "title"});
        s.kinds({"shot", "title"});
        s.check([](Reader& reader, const Node& node, FilmPartSection& part) {
            const Entry* shot = node.find("shot");
            part.place = node.place;
            part.shot_place = shot != nullptr ? shot->value.place : node.place;
            warn_of_values(reader, node.find("title"));
            warn_of_values(reader, node.find("subtitle"));
            if (part.from && part.to && !(*part.from < *part.to)) {
                reader.error(node.find("to")->value.place, "'to' must be after 'from'");
            }
        });
        return s;
    }();
    return spec;
}

ValueType<FilmPartSection> part() {
    const ValueType<std::string> name = text("the name of a file");
    ValueType<FilmPartSection> shot;
    shot.info = name.info;
    shot.read = [read = name.read](Reader& reader,
                                   const Node& node) -> std::optional<FilmPartSection> {
        FilmPartSection result;
        result.shot = read(reader, node);
        result.place = result.shot_place = node.place;
        return result.shot ? std::optional(std::move(result)) : std::nullopt;
    };
    return any_of<FilmPartSection>({{is_scalar, shot}, {is_map, record(part_spec())}});
}

}  // namespace

const MapSpec<FilmSection>& film_spec() {
    static const MapSpec<FilmSection> spec = [] {
        MapSpec<FilmSection> s(
            "film",
            "One film of several shots, with cuts, fades and title cards. A file "
            "with it has no sections of a shot besides `output`, which says how "
            "the film is encoded; each shot keeps its own view.");
        s.key("size", &FilmSection::size, picture_size(),
              "width and height of the film, instead of those of the shots. They have to agree "
              "without it");
        s.key("fps", &FilmSection::fps, frame_rate(),
              "frames per second, instead of those of the shots. They have to agree without it");
        s.key(
             "shots", &FilmSection::parts, list_of(part(), 1, 1000),
             "the parts of the film in their order: names of shots' files, shots with changes, and "
             "title cards")
            .required();
        return s;
    }();
    return spec;
}

}  // namespace carom::pipeline::config
