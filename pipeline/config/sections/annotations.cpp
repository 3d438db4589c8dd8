// The keys of the section `annotations`.
#include <algorithm>
#include <filesystem>
#include <string_view>
#include <utility>
#include <variant>

#include <fmt/core.h>

#include "pipeline/config/sections/occurrences.h"
#include "pipeline/config/sections/sections.h"
#include "pipeline/config/show_quantity.h"
#include "pipeline/config/text.h"
#include "pipeline/config/value_types.h"
#include "pipeline/picture/fonts.h"
#include "pipeline/picture/value_text.h"

namespace carom::pipeline::config {

namespace {

constexpr double kLongest = 3600;  // s

/// [x, y], [x, y, z] or the name of a ball or moving object.
ValueType<ScenePoint> scene_point() {
    const auto fixed =
        convert<ScenePoint>(coordinates(Dimension::length), [](const Coordinates& point) {
            return ScenePoint{{}, point.value};
        });
    const auto object = convert<ScenePoint>(name_of(ReferenceKind::moving), [](std::string name) {
        return ScenePoint{std::move(name)};
    });
    return any_of<ScenePoint>({{is_list, fixed}, {is_scalar, object}});
}

const MapSpec<PathAnnotation>& path_spec() {
    static const MapSpec<PathAnnotation> spec = [] {
        MapSpec<PathAnnotation> s("drawn path", "The way of a ball's or object's centre.");
        s.key("of", &PathAnnotation::of, name_of(ReferenceKind::moving), "the ball or object")
            .required();
        s.key("part", &PathAnnotation::part,
              choice<PathPart>({{"so_far", PathPart::so_far},
                                {"ahead", PathPart::ahead},
                                {"whole", PathPart::whole}}),
              "the way up to the frame's time, from there on, or all of it");
        s.key("length", &PathAnnotation::length, time(above_up_to(0, kLongest)),
              "how much time of the way is shown. The default is all");
        s.key("fading", &PathAnnotation::fading, time(between(0, kLongest)),
              "time over which the line fades away from the ball; 0 s: it does not");
        s.key("marks", &PathAnnotation::marks, time(between(0.001, kLongest)),
              "time between dots on the line: the farther they are apart, the faster is the ball");
        s.key("number", &PathAnnotation::number, integer(0, 99),
              "number at its end; 0: none. The default is the place among the shot's paths if it "
              "has several, otherwise none");
        s.key("on_cloth", &PathAnnotation::on_cloth, boolean(),
              "whether the line is on the cloth under the ball instead of at its centre");
        return s;
    }();
    return spec;
}

const MapSpec<AimAnnotation>& aim_spec() {
    static const MapSpec<AimAnnotation> spec = [] {
        MapSpec<AimAnnotation> s("aim line",
                                 "The straight line along which a ball is aimed. It ends where the "
                                 "ball touches the first ball or cushion in its way.");
        s.key("of", &AimAnnotation::of, name_of(ReferenceKind::moving), "the ball").required();
        s.key("toward", &AimAnnotation::toward, scene_point(),
              "point or ball, seen from where the ball is. The default is the aim of the first "
              "strike on the ball, from where it was then");
        s.key("direction", &AimAnnotation::direction, angle(),
              "instead of `toward`: angle from +x, counter-clockwise seen from above");
        s.key("length", &AimAnnotation::length, length(above_up_to(0, 100)),
              "length of the line, instead of where it ends by itself");
        s.at_most_one_of({"toward", "direction"});
        return s;
    }();
    return spec;
}

const MapSpec<GhostAnnotation>& ghost_spec() {
    static const MapSpec<GhostAnnotation> spec = [] {
        MapSpec<GhostAnnotation> s("ghost ball",
                                   "The ghost ball: where a ball is when it first touches another "
                                   "one.");
        s.key("of", &GhostAnnotation::of, name_of(ReferenceKind::moving), "the ball").required();
        s.key("on", &GhostAnnotation::on, name_of(ReferenceKind::moving),
              "the ball that it touches")
            .required();
        return s;
    }();
    return spec;
}

const MapSpec<TangentAnnotation>& tangent_spec() {
    static const MapSpec<TangentAnnotation> spec = [] {
        MapSpec<TangentAnnotation> s(
            "tangent line",
            "The tangent line: through the ghost ball, at right angles to the line of the centres. "
            "A ball that slides without spin leaves along it.");
        s.key("of", &TangentAnnotation::of, name_of(ReferenceKind::moving), "the ball").required();
        s.key("on", &TangentAnnotation::on, name_of(ReferenceKind::moving),
              "the ball that it touches")
            .required();
        s.key("length", &TangentAnnotation::length, length(above_up_to(0, 100)),
              "length of the line from the ghost ball");
        return s;
    }();
    return spec;
}

const MapSpec<VelocityAnnotation>& velocity_spec() {
    static const MapSpec<VelocityAnnotation> spec = [] {
        MapSpec<VelocityAnnotation> s("velocity arrow", "An arrow along a ball's velocity.");
        s.key("of", &VelocityAnnotation::of, name_of(ReferenceKind::moving), "the ball").required();
        s.key("during", &VelocityAnnotation::during, time(above_up_to(0, 100)),
              "the arrow is as long as the way that the ball would go in this time");
        s.key("value", &VelocityAnnotation::value, boolean(),
              "whether the speed in m/s is written at its end");
        return s;
    }();
    return spec;
}

const MapSpec<SpinAnnotation>& spin_spec() {
    static const MapSpec<SpinAnnotation> spec = [] {
        MapSpec<SpinAnnotation> s("spin arrow", "A round arrow about the axis of a ball's spin.");
        s.key("of", &SpinAnnotation::of, name_of(ReferenceKind::moving), "the ball").required();
        s.key("during", &SpinAnnotation::during, time(above_up_to(0, 100)),
              "the arrow turns by as much as the ball would in this time, at most 300 degrees");
        s.key("value", &SpinAnnotation::value, boolean(),
              "whether the angular velocity in rad/s is written at its end");
        return s;
    }();
    return spec;
}

/// A time or `rolling`.
ValueType<MeasuringTime> measuring_time() {
    const auto word = convert<MeasuringTime>(choice<bool>({{"rolling", true}}), [](bool) {
        return MeasuringTime{0, true};
    });
    const auto seconds = convert<MeasuringTime>(time(between(0, kLongest)), [](double value) {
        return MeasuringTime{value, false};
    });
    ValueType<MeasuringTime> result =
        any_of<MeasuringTime>({{is_exactly("rolling"), word}, {is_number, seconds}});
    result.show = [](const MeasuringTime& value) {
        return value.is_rolling ? "rolling" : show(value.seconds, Dimension::time);
    };
    return result;
}

const MapSpec<AngleAnnotation>& angle_spec() {
    static const MapSpec<AngleAnnotation> spec = [] {
        MapSpec<AngleAnnotation> s("drawn angle", "An angle, seen from above, with its value.");
        s.key("points", &AngleAnnotation::points, list_of(scene_point(), 3, 3),
              "[point on one side, vertex, point on the other side]: positions or balls");
        s.key("between", &AngleAnnotation::between, list_of(name_of(ReferenceKind::moving), 2, 2),
              "two balls: the angle between their ways after they first touch");
        s.set(
            "deflection", list_of(name_of(ReferenceKind::touchable), 2, 2),
            [](AngleAnnotation& angle, std::vector<std::string> names) {
                angle.deflection = std::move(names);
            },
            "a ball and what it touches (a ball, `cushion`): the angle by which its way turns at "
            "the first contact");
        s.key("after", &AngleAnnotation::after, measuring_time(),
              "time after the contact at which the ways are measured, or `rolling`: as soon as the "
              "ball rolls, so that its way is straight. A way is measured before the ball's next "
              "contact in any case");
        s.key("radius", &AngleAnnotation::radius, length(above_up_to(0, 10)), "radius of the arc");
        s.key("value", &AngleAnnotation::value, boolean(),
              "whether the angle in degrees is written beside the arc");
        s.exactly_one_of({"points", "between", "deflection"});
        return s;
    }();
    return spec;
}

const MapSpec<ZoneAnnotation>& zone_spec() {
    static const MapSpec<ZoneAnnotation> spec = [] {
        MapSpec<ZoneAnnotation> s("zone", "A part of the cloth.");
        s.key("polygon", &ZoneAnnotation::polygon, list_of(vector2(Dimension::length), 3),
              "its corners");
        s.key("radius", &ZoneAnnotation::radius, length(above_up_to(0, 10)),
              "radius of a circle, instead of corners");
        s.key("at", &ZoneAnnotation::at, scene_point(),
              "centre of the circle: a position, or a ball that it follows")
            .goes_with({"radius"});
        s.exactly_one_of({"polygon", "radius"});
        return s;
    }();
    return spec;
}

constexpr const char* kText = "a text, with values in braces";

const MapSpec<LabelAnnotation>& label_spec() {
    static const MapSpec<LabelAnnotation> spec = [] {
        MapSpec<LabelAnnotation> s("label", "A text above a ball, which follows it.");
        s.key("of", &LabelAnnotation::of, name_of(ReferenceKind::moving), "the ball").required();
        s.key("text", &LabelAnnotation::text, text_with_values(kText),
              "the text, with values in braces: \"{cue.speed:.1f} m/s\"")
            .required();
        return s;
    }();
    return spec;
}

const MapSpec<TitleAnnotation>& title_spec() {
    static const MapSpec<TitleAnnotation> spec = [] {
        MapSpec<TitleAnnotation> s("title", "Large text, with a smaller line under it.");
        s.key("text", &TitleAnnotation::text, text_with_values(kText), "the title").required();
        s.key("subtitle", &TitleAnnotation::subtitle, text_with_values(kText), "the line under it");
        return s;
    }();
    return spec;
}

const MapSpec<TipAnnotation>& tip_spec() {
    static const MapSpec<TipAnnotation> spec = [] {
        MapSpec<TipAnnotation> s("tip diagram",
                                 "A diagram of where the stick hits a ball, as the shooter sees "
                                 "it.");
        s.key("of", &TipAnnotation::of, name_of(ReferenceKind::ball),
              "the ball; of several strikes on it the first one counts")
            .required();
        return s;
    }();
    return spec;
}

const MapSpec<PlanAnnotation>& plan_spec() {
    static const MapSpec<PlanAnnotation> spec = [] {
        MapSpec<PlanAnnotation> s("small plan", "The table from above, as a small picture.");
        s.key("paths", &PlanAnnotation::has_paths, boolean(),
              "whether it shows the ways of the balls up to the frame's time");
        return s;
    }();
    return spec;
}

/// A word for one of the installed fonts, or a file.
ValueType<std::string> font() {
    std::vector<std::pair<std::string, std::string>> choices;
    for (const NamedFont& named : named_fonts()) {
        choices.emplace_back(named.name, named.file);
    }
    ValueType<std::string> word = choice<std::string>(choices);
    word.read = [read = word.read](Reader& reader, const Node& node) -> std::optional<std::string> {
        std::optional<std::string> path = read(reader, node);
        std::error_code ignored;
        if (path && !std::filesystem::exists(*path, ignored)) {
            reader.error(node.place, fmt::format("the font {} is not installed (package "
                                                 "fonts-dejavu-core); its file would be {}",
                                                 quote(node.text), quote(*path)));
            return std::nullopt;
        }
        return path;
    };
    const auto is_named = [](const Node& node) {
        return node.is_scalar() && std::ranges::any_of(named_fonts(), [&](const NamedFont& named) {
                   return named.name == node.text;
               });
    };
    return any_of<std::string>({{is_named, word}, {is_scalar, file(FileKind::font)}});
}

/// `true`, `false` or a colour.
ValueType<TextBox> box() {
    const auto word = convert<TextBox>(boolean(), [](bool has_box) {
        return has_box ? TextBox{} : TextBox{Vec3(0), 0};
    });
    const auto coloured = convert<TextBox>(colour(between(0, 1)), [](const Vec3& colour) {
        return TextBox{colour, TextBox{}.opacity};
    });
    const auto is_boolean = [](const Node& node) {
        return is_word(node) && !node.quoted && !node.text.starts_with('#');
    };
    return any_of<TextBox>({{is_boolean, word}, {[](const Node&) { return true; }, coloured}});
}

/// A word for a corner, an edge or the centre, or two fractions.
ValueType<PicturePlace> picture_place() {
    const auto edge = [](double x, double y) { return PicturePlace{{x, y}, true}; };
    using Named = std::pair<std::string, int>;
    const std::vector<PicturePlace> places{edge(0, 0),   edge(0.5, 0),   edge(1, 0),
                                           edge(0, 0.5), edge(0.5, 0.5), edge(1, 0.5),
                                           edge(0, 1),   edge(0.5, 1),   edge(1, 1)};
    const auto words = convert<PicturePlace>(
        choice<int>({Named{"top_left", 0}, Named{"top", 1}, Named{"top_right", 2}, Named{"left", 3},
                     Named{"centre", 4}, Named{"right", 5}, Named{"bottom_left", 6},
                     Named{"bottom", 7}, Named{"bottom_right", 8}}),
        [places](int index) { return places[static_cast<std::size_t>(index)]; });
    const auto fractions =
        convert<PicturePlace>(vector2(Dimension::none, between(0, 1)), [](const Vec2& at) {
            return PicturePlace{at, false};
        });
    return any_of<PicturePlace>({{is_list, fractions}, {is_scalar, words}});
}

const std::vector<std::string> kScene{"path", "aim",   "ghost", "tangent", "velocity",
                                      "spin", "angle", "zone",  "label"};
const std::vector<std::string> kPicture{"text", "title", "tip", "plan", "image"};

/// Adds a key that decides the kind of the annotation.
template <class Kind>
void add_kind(MapSpec<Annotation>& s, std::string_view name, const ValueType<Kind>& type,
              std::string_view description) {
    s.set(
        name, type, [](Annotation& annotation, Kind kind) { annotation.kind = std::move(kind); },
        description);
}

void add_kinds(MapSpec<Annotation>& s) {
    add_kind(s, "path", record(path_spec()), "in the scene: the way of a ball");
    add_kind(s, "aim", record(aim_spec()), "in the scene: an aim line");
    add_kind(s, "ghost", record(ghost_spec()), "in the scene: a ghost ball");
    add_kind(s, "tangent", record(tangent_spec()), "in the scene: a tangent line");
    add_kind(s, "velocity", record(velocity_spec()), "in the scene: an arrow of velocity");
    add_kind(s, "spin", record(spin_spec()), "in the scene: a round arrow of spin");
    add_kind(s, "angle", record(angle_spec()), "in the scene: an angle");
    add_kind(s, "zone", record(zone_spec()), "in the scene: a part of the cloth");
    add_kind(s, "label", record(label_spec()), "in the scene: a text that follows a ball");
    add_kind(
        s, "text",
        convert<TextAnnotation>(text_with_values(kText),
                                [](std::string text) { return TextAnnotation{std::move(text)}; }),
        "on the picture: lines of text, with values in braces: \"{cue.speed:.1f} m/s\"");
    add_kind(s, "title", record(title_spec()), "on the picture: a title");
    add_kind(s, "tip", record(tip_spec()), "on the picture: where the stick hits a ball");
    add_kind(s, "plan", record(plan_spec()), "on the picture: the table from above");
    add_kind(
        s, "image",
        convert<ImageAnnotation>(file(FileKind::annotation_picture),
                                 [](std::string path) { return ImageAnnotation{std::move(path)}; }),
        "on the picture: the picture of a file, such as a logo");
    std::vector<std::string> all = kScene;
    all.insert(all.end(), kPicture.begin(), kPicture.end());
    s.exactly_one_of(all);
    s.kinds(all);
}

ValueType<AnnotationTime> annotation_time() {
    const auto number = convert<AnnotationTime>(time(between(0, kLongest)), [](double seconds) {
        return AnnotationTime{seconds, false};
    });
    const auto at_moment = convert<AnnotationTime>(scene_time(), [](double seconds) {
        return AnnotationTime{seconds, true};
    });
    ValueType<AnnotationTime> result = any_of<AnnotationTime>(
        {{[](const Node& node) { return !node.is_map(); }, number}, {is_map, at_moment}});
    result.info = scene_time().info;
    return result;
}

/// `true`, `false` or a length.
ValueType<double> lit() {
    const auto word = convert<double>(boolean(), [](bool is_lit) {
        constexpr double kUsual = 0.005;  // m
        return is_lit ? kUsual : 0;
    });
    const auto is_boolean = [](const Node& node) {
        return node.is_scalar() && (node.text == "true" || node.text == "false");
    };
    ValueType<double> result = any_of<double>(
        {{is_boolean, word}, {[](const Node&) { return true; }, length(between(0.0005, 0.1))}});
    result.show = [](double diameter) {
        return diameter > 0 ? show(diameter, Dimension::length) : "false";
    };
    return result;
}

void add_times(MapSpec<Annotation>& s) {
    s.key("from", &Annotation::from, annotation_time(),
          "time at which it appears: scene time of annotations in the scene, video time of those "
          "on the picture; or a moment, on the picture as soon as the film has first shown it. The "
          "default is the start");
    s.key("to", &Annotation::to, annotation_time(),
          "time at which it disappears. The default is the end");
    s.key("fade", &Annotation::fade, time(between(0, kLongest)),
          "how long it takes to appear after `from` and to disappear before `to`");
}

void add_look(MapSpec<Annotation>& s) {
    s.key("opacity", &Annotation::opacity, number(above_up_to(0, 1)), "1: nothing shines through");
    s.key("colour", &Annotation::colour, colour(between(0, 1)),
          "colour of lines, areas and letters. Each kind has its own default, and paths have "
          "different ones in turn")
        .goes_with({"path", "aim", "ghost", "tangent", "velocity", "spin", "angle", "zone", "label",
                    "text", "title", "tip"});
    s.key("width", &Annotation::width, number(above_up_to(0, 0.2)),
          "width of lines, in picture heights. Each kind has its own default, about 0.006")
        .goes_with({"path", "aim", "ghost", "tangent", "velocity", "spin", "angle", "zone"});
    s.key("dash", &Annotation::dash,
          choice<Dash>({{"solid", Dash::solid},
                        {"dashed", Dash::dashed},
                        {"dotted", Dash::dotted},
                        {"dash_dot", Dash::dash_dot}}),
          "pattern of lines. Each kind has its own default, and paths have different ones in turn")
        .goes_with({"path", "aim", "ghost", "tangent", "velocity", "spin", "angle", "zone"});
    s.key("font", &Annotation::font, font(),
          "`sans_bold` (the default), `sans`, `serif`, `serif_bold`, `mono`, `mono_bold`, or a "
          "file with a font")
        .goes_with({"path", "velocity", "spin", "angle", "label", "text", "title"});
    s.key("size", &Annotation::size, number(between(0.005, 1)),
          "height of a line of text, or of a diagram, plan or picture, in picture heights. Each "
          "kind has its own default")
        .goes_with({"path", "velocity", "spin", "angle", "label", "text", "title", "tip", "plan",
                    "image"});
    s.key("box", &Annotation::box, box(),
          "whether a box is behind the text, or its colour. The default is true for `text` and for "
          "the numbers of paths. Without a box the letters have a dark edge")
        .goes_with({"path", "velocity", "spin", "angle", "label", "text", "title"});
    s.key("lit", &Annotation::lit, lit(),
          "whether it is a thin object in the scene instead, which is lit, casts shadows and is "
          "seen in mirrors, and is there for the whole film; or its diameter. The default is "
          "false, and 5 mm for true. Only for what stands still")
        .goes_with({"path", "aim", "ghost", "tangent", "angle", "zone"});
    s.key("position", &Annotation::place, picture_place(),
          "`top_left`, `top`, `top_right`, `left`, `centre`, `right`, `bottom_left`, `bottom`, "
          "`bottom_right`, or [x, y] of its centre in fractions of the picture, from the top left")
        .goes_with(kPicture);
}

void check_times(Reader& reader, const Node& node, Annotation& annotation) {
    // A moment and a number may be on different clocks, and open moments have no time yet.
    const bool are_comparable = annotation.from && annotation.to &&
                                annotation.from->is_moment == annotation.to->is_moment &&
                                (reader.knows_motion() || !annotation.from->is_moment);
    if (are_comparable && annotation.from->seconds >= annotation.to->seconds) {
        reader.error(node.find("to")->value.place, "'to' must be after 'from'");
    }
}

}  // namespace

ValueType<std::string> text_with_values(std::string noun) {
    ValueType<std::string> result = text(std::move(noun));
    result.read = [read = result.read](Reader& reader,
                                       const Node& node) -> std::optional<std::string> {
        std::optional<std::string> value = read(reader, node);
        const auto pieces = parse_value_text(value.value_or(""));
        if (const auto* problem = std::get_if<TextProblem>(&pieces)) {
            // The suggestion would replace the whole text, so only the sentence has it.
            reader.error(
                reader.key_place(),
                problem->sentence + hint(problem->unknown, problem->known).text + problem->advice);
        }
        return value;
    };
    return result;
}

const MapSpec<Annotation>& annotation_spec() {
    static const MapSpec<Annotation> spec = [] {
        MapSpec<Annotation> s(
            "annotation",
            "Graphics that are drawn on the finished frames, in their order: in the scene, where "
            "balls and cushions hide what is behind them, or on the picture. No frame is rendered "
            "again for them.");
        add_kinds(s);
        add_times(s);
        add_look(s);
        s.check(check_times);
        return s;
    }();
    return spec;
}

}  // namespace carom::pipeline::config
