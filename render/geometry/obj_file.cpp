#include "render/geometry/obj_file.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <map>
#include <string>
#include <utility>

#include <fmt/core.h>

#include "core/limits.h"
#include "render/geometry/mesh_builder.h"
#include "render/geometry/mesh_text.h"
#include "render/geometry/triangle_mesh.h"
#include "render/geometry/validity.h"

namespace carom::render {
namespace {

constexpr std::size_t kMaxWords = kMaxCorners + 8;  // of a statement

/// Statements without a meaning for a mesh. Those of curves and surfaces come after `surf`.
constexpr std::array kIgnored = {"p",          "l",         "g",        "o",       "s",     "mg",
                                 "usemap",     "maplib",    "bevel",    "lod",     "ctech", "stech",
                                 "shadow_obj", "trace_obj", "vp",       "deg",     "bmat",  "step",
                                 "parm",       "trim",      "hole",     "scrv",    "sp",    "end",
                                 "con",        "cstype",    "c_interp", "d_interp"};

/// Statements, each a list of words. A backslash at the end of a line joins it with the next one.
class Statements {
  public:
    explicit Statements(std::string_view text) : text_(text) {}

    /// Reads the next statement with a word; false at the end of the text.
    bool next(std::vector<std::string_view>& words) {
        words.clear();
        while (at_ < text_.size()) {
            line_ = words.empty() ? physical_line_ : line_;
            if (!read_line(words) && !words.empty()) {
                return true;
            }
        }
        return !words.empty();
    }

    [[nodiscard]] std::size_t line() const { return line_; }  // of the statement's first word

  private:
    /// Whether the statement continues in the next line.
    bool read_line(std::vector<std::string_view>& words) {
        const std::size_t end = std::min(text_.find_first_of("\r\n", at_), text_.size());
        const std::string_view line = text_.substr(at_, end - at_);
        at_ = after_line_end(text_, end);
        const std::size_t number = physical_line_++;
        const std::size_t first = words.size();
        add_words(line, words);
        if (remove_comment(words, first)) {
            return false;
        }
        if (words.size() > kMaxWords) {
            refuse(number, fmt::format("a statement of more than {} words", kMaxWords));
        }
        if (words.size() == first || !words.back().ends_with('\\')) {
            return false;
        }
        words.back().remove_suffix(1);
        if (words.back().empty()) {
            words.pop_back();
        }
        return true;
    }

    /// Removes a comment from the words of a line; whether it had one. Names may contain a '#', and
    /// so may numbers that are none ("-1.#IND").
    static bool remove_comment(std::vector<std::string_view>& words, std::size_t first) {
        const bool is_named = !words.empty() && words[0].size() > 2 && !words[0].starts_with('#');
        if (is_named) {
            return false;
        }
        for (std::size_t i = first; i < words.size(); ++i) {
            const std::size_t mark = words[i].find('#');
            if (mark == std::string_view::npos || (mark > 0 && words[i][mark - 1] == '.')) {
                continue;
            }
            words[i] = words[i].substr(0, mark);
            words.resize(mark > 0 ? i + 1 : i);
            return true;
        }
        return false;
    }

    std::string_view text_;
    std::size_t at_ = 0;
    std::size_t physical_line_ = 1;
    std::size_t line_ = 1;
};

class ObjReader {
  public:
    explicit ObjReader(std::string_view text) : statements_(text) {}

    MeshReading read() {
        read_statements();
        build_mesh(mesh_, reading_, blemishes_);
        reading_.warnings = blemishes_.warnings();
        return std::move(reading_);
    }

    std::vector<MeshReading> read_parts() {
        read_statements();
        std::vector<MeshReading> parts;
        for (std::uint32_t i = 0; i <= reading_.materials.size(); ++i) {
            const bool is_named = i < reading_.materials.size();
            MeshReading part = reading_;
            part.materials.clear();
            if (is_named) {
                part.materials.push_back(reading_.materials[i]);
            }
            build_mesh(mesh_, part, blemishes_, is_named ? i : MeshReading::kNoMaterial);
            if (!part.mesh.triangles.empty()) {
                parts.push_back(std::move(part));
            }
        }
        parts.front().warnings = blemishes_.warnings();
        return parts;
    }

  private:
    using Words = std::vector<std::string_view>;

    void read_statements() {
        Words words;
        while (statements_.next(words)) {
            read_statement(words);
        }
        if (mesh_.faces.empty()) {
            refuse(0, "the file has no faces; is it an OBJ file?");
        }
    }

    void read_statement(const Words& words) {
        const std::string_view key = words[0];
        if (key == "v") {
            read_point(words);
        } else if (key == "vn") {
            read_normal(words);
        } else if (key == "vt") {
            read_uv(words);
        } else if (key == "f" || key == "fo") {
            read_face(words);
        } else if (key == "usemtl") {
            read_material(words);
        } else if (key == "mtllib") {
            reading_.libraries.push_back(rest_of(words));
        } else if (key == "curv" || key == "curv2" || key == "surf") {
            blemishes_.add(MeshBlemish::curved_surface, statements_.line());
        } else if (std::find(kIgnored.begin(), kIgnored.end(), key) == kIgnored.end()) {
            blemishes_.add(MeshBlemish::unknown_statement, statements_.line());
        }
    }

    /// A word that must be a number; NaN for one that is none in the words of other programs.
    [[nodiscard]] double number(std::string_view word) const {
        const auto value = number_of(word);
        if (!value) {
            refuse(statements_.line(), not_a_number(word));
        }
        return *value;
    }

    void read_point(const Words& words) {
        if (words.size() < 4) {
            refuse(
                statements_.line(),
                fmt::format("a vertex of {} coordinates; it needs x, y and z", words.size() - 1));
        }
        Vec3 point;
        for (std::size_t i = 1; i < words.size(); ++i) {  // after z a weight or a colour
            const double value = number(words[i]);
            if (i > 3) {
                continue;
            }
            point[static_cast<int>(i) - 1] = value;
            if (!is_finite(V3f(Vec3(value)))) {
                refuse(statements_.line(), "a vertex has the coordinate " + quoted(words[i]) +
                                               ", which is not a finite number");
            }
        }
        add(mesh_.points, point, "vertices");
    }

    void read_normal(const Words& words) {
        Vec3 normal(0, 0, 0);
        for (std::size_t i = 1; i < words.size(); ++i) {
            const double value = number(words[i]);
            if (i <= 3) {
                normal[static_cast<int>(i) - 1] = value;
            }
        }
        const V3f narrow(normal);
        if (words.size() != 4 || !is_finite(narrow) || !(narrow.length() > 0)) {
            blemishes_.add(MeshBlemish::bad_normal, statements_.line());
            normal = Vec3(0, 0, 0);
        }
        add(mesh_.normals, normal, "normals");
    }

    void read_uv(const Words& words) {
        if (words.size() < 2) {
            refuse(statements_.line(), "a texture coordinate without a number");
        }
        Vec2 uv(0, 0);
        for (std::size_t i = 1; i < words.size(); ++i) {  // after v a depth
            const double value = number(words[i]);
            if (i <= 2) {
                uv[static_cast<int>(i) - 1] = value;
            }
        }
        if (!is_finite(V3f(Vec3(uv.x, uv.y, 0)))) {
            blemishes_.add(MeshBlemish::bad_uv, statements_.line());
            uv = Vec2(0, 0);
        }
        add(mesh_.uv, uv, "texture coordinates");
    }

    template <class Value>
    void add(std::vector<Value>& list, const Value& value, const char* what) const {
        if (list.size() >= input_limit(kMaxMeshVertices)) {
            refuse(statements_.line(), beyond_limit(input_limit(kMaxMeshVertices), what));
        }
        list.push_back(value);
    }

    /// Names with blanks are written as they are.
    static std::string rest_of(const Words& words) {
        std::string rest;
        for (std::size_t i = 1; i < words.size(); ++i) {
            rest.append(i > 1 ? " " : "").append(words[i]);
        }
        return rest;
    }

    void read_material(const Words& words) {
        const std::string name = rest_of(words);
        const auto [known, is_new] = material_numbers_.try_emplace(
            name, static_cast<std::uint32_t>(reading_.materials.size()));
        if (is_new) {
            reading_.materials.push_back(name);
        }
        material_ = known->second;
    }

    void read_face(const Words& words) {
        check_corner_count(words.size() - 1, statements_.line());
        for (std::size_t i = 1; i < words.size(); ++i) {
            read_corner(words[i]);
        }
        triangle_count_ += words.size() - 3;
        if (triangle_count_ > input_limit(kMaxMeshTriangles)) {
            refuse(statements_.line(), beyond_limit(input_limit(kMaxMeshTriangles), "triangles"));
        }
        mesh_.faces.push_back(
            {static_cast<std::uint32_t>(words.size() - 1), material_, statements_.line()});
    }

    /// "1", "1/2", "1//3" or "1/2/3". An empty field, also the last one, means none.
    void read_corner(std::string_view word) {
        MeshCorner corner{kNoIndex, kNoIndex, kNoIndex};
        const std::array counts{mesh_.points.size(), mesh_.uv.size(), mesh_.normals.size()};
        std::string_view left = word;
        for (std::size_t field = 0;; ++field) {
            const std::size_t end = std::min(left.find('/'), left.size());
            if (field == 3) {
                refuse(statements_.line(), "the corner " + quoted(word) +
                                               " has more than a vertex, a "
                                               "texture coordinate and a normal");
            }
            if (end > 0) {
                corner[field] = index_of(left.substr(0, end), word, field, counts[field]);
            }
            if (end == left.size()) {
                break;
            }
            left.remove_prefix(end + 1);
        }
        if (corner[0] == kNoIndex) {
            refuse(statements_.line(), "the corner " + quoted(word) + " has no vertex");
        }
        mesh_.corners.push_back(corner);
    }

    /// Counted from 0. In the file 1 is the first entry, and -1 the last one before the face.
    std::uint32_t index_of(std::string_view digits, std::string_view word, std::size_t field,
                           std::size_t count) {
        std::string_view number = digits;
        number.remove_prefix(number.starts_with('+') ? 1 : 0);
        std::int64_t index = 0;
        const auto [stop, error] =
            std::from_chars(number.data(), number.data() + number.size(), index);
        if (stop != number.data() + number.size() || error == std::errc::invalid_argument) {
            refuse(statements_.line(),
                   "the corner " + quoted(word) + " is not made of whole numbers");
        }
        if (index == 0 && field > 0 && error == std::errc()) {
            blemishes_.add(MeshBlemish::index_zero, statements_.line());
            return kNoIndex;
        }
        if (index == 0 && error == std::errc()) {
            refuse(statements_.line(), "a face refers to vertex 0; OBJ counts from 1");
        }
        const std::int64_t at = index > 0 ? index - 1 : static_cast<std::int64_t>(count) + index;
        if (error != std::errc() || at < 0 || at >= kNoIndex) {
            refuse(statements_.line(), reference_problem(field, digits, count));
        }
        return static_cast<std::uint32_t>(at);
    }

    Statements statements_;
    MeshFaces mesh_;
    std::map<std::string, std::uint32_t> material_numbers_;
    std::uint32_t material_ = MeshReading::kNoMaterial;
    std::size_t triangle_count_ = 0;
    MeshReading reading_;
    MeshBlemishes blemishes_;
};

}  // namespace

MeshReading read_obj(std::string_view text) {
    return ObjReader(text).read();
}

std::vector<MeshReading> read_obj_parts(std::string_view text) {
    return ObjReader(text).read_parts();
}

}  // namespace carom::render
