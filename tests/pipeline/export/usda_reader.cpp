#include "tests/pipeline/export/usda_reader.h"

#include <algorithm>
#include <cctype>
#include <stdexcept>

namespace carom::testing {

namespace {

class Reader {
  public:
    explicit Reader(std::string_view text) : text_(text) {}

    UsdaPrim file() {
        constexpr std::string_view kFirstLine = "#usda 1.0\n";
        if (!text_.starts_with(kFirstLine)) {
            fail("no '#usda 1.0' in the first line");
        }
        at_ = kFirstLine.size();
        UsdaPrim root;
        if (peek() == '(') {
            root.metadata = metadata();
        }
        while (peek() != '\0') {
            root.children.push_back(prim());
        }
        return root;
    }

  private:
    [[noreturn]] void fail(const std::string& what) const {
        const auto line =
            1 + std::count(text_.begin(), text_.begin() + static_cast<long>(at_), '\n');
        throw std::runtime_error("line " + std::to_string(line) + ": " + what);
    }

    char peek() {
        while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) {
            ++at_;
        }
        return at_ < text_.size() ? text_[at_] : '\0';
    }

    void expect(char letter) {
        if (peek() != letter) {
            fail(std::string("expected '") + letter + "'");
        }
        ++at_;
    }

    bool accept(char letter) {
        if (peek() != letter) {
            return false;
        }
        ++at_;
        return true;
    }

    std::string word() {
        peek();
        const std::size_t first = at_;
        constexpr std::string_view kOthers = "_:.[]-+";
        while (at_ < text_.size() && (std::isalnum(static_cast<unsigned char>(text_[at_])) != 0 ||
                                      kOthers.find(text_[at_]) != std::string_view::npos)) {
            ++at_;
        }
        if (at_ == first) {
            fail("expected a word");
        }
        return std::string(text_.substr(first, at_ - first));
    }

    std::string until(char end) {
        ++at_;
        std::string result;
        while (at_ < text_.size() && text_[at_] != end) {
            at_ += text_[at_] == '\\' ? 1 : 0;
            result += text_[at_++];
        }
        expect(end);
        return result;
    }

    UsdaValue list(char end) {
        UsdaValue value;
        ++at_;
        while (!accept(end)) {
            value.items.push_back(this->value());
            if (!accept(',')) {
                expect(end);
                break;
            }
        }
        return value;
    }

    UsdaValue value() {
        switch (peek()) {
            case '(':
                return list(')');
            case '[':
                return list(']');
            case '"':
                return {until('"'), {}};
            case '<':
                return {until('>'), {}};
            case '@':
                return {until('@'), {}};
            default:
                return {plain(), {}};
        }
    }

    /// A number or a bare word.
    std::string plain() {
        const std::size_t first = at_;
        constexpr std::string_view kEnds = ",)]};: \n";
        while (at_ < text_.size() && kEnds.find(text_[at_]) == std::string_view::npos) {
            ++at_;
        }
        if (at_ == first) {
            fail("expected a value");
        }
        return std::string(text_.substr(first, at_ - first));
    }

    std::map<std::string, UsdaValue> metadata() {
        std::map<std::string, UsdaValue> result;
        expect('(');
        while (!accept(')')) {
            std::string name = word();
            if (name == "prepend") {
                name = word();
            }
            expect('=');
            if (!result.emplace(name, value()).second) {
                fail("'" + name + "' twice");
            }
            accept(';');
        }
        return result;
    }

    UsdaPrim prim() {
        if (word() != "def") {
            fail("expected a prim");
        }
        UsdaPrim prim;
        prim.type = word();
        peek();
        prim.name = until('"');
        const bool is_name =
            !prim.name.empty() && std::isdigit(static_cast<unsigned char>(prim.name[0])) == 0 &&
            std::ranges::all_of(prim.name,
                                [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; });
        if (!is_name) {
            fail("'" + prim.name + "' is no name for a prim");
        }
        if (peek() == '(') {
            prim.metadata = metadata();
        }
        expect('{');
        while (!accept('}')) {
            const std::size_t here = at_;
            const bool is_prim = word() == "def";
            at_ = here;
            if (is_prim) {
                prim.children.push_back(this->prim());
                if (std::ranges::count(prim.children, prim.children.back().name, &UsdaPrim::name) !=
                    1) {
                    fail("two prims '" + prim.children.back().name + "' in one place");
                }
            } else {
                attribute(prim);
            }
        }
        return prim;
    }

    void attribute(UsdaPrim& prim) {
        UsdaAttribute result;
        result.type = word();
        if (result.type == "uniform") {
            result.type = word();
        }
        std::string name = word();
        constexpr std::string_view kSamples = ".timeSamples";
        if (accept('=')) {
            if (name.ends_with(kSamples)) {
                name.resize(name.size() - kSamples.size());
                result.samples = samples();
            } else {
                result.value = value();
            }
        }
        if (peek() == '(') {
            metadata();
        }
        if (!prim.attributes.emplace(name, std::move(result)).second) {
            fail("'" + name + "' twice");
        }
    }

    std::vector<std::pair<double, UsdaValue>> samples() {
        std::vector<std::pair<double, UsdaValue>> result;
        expect('{');
        while (!accept('}')) {
            peek();
            const double code = std::stod(plain());
            if (!result.empty() && code <= result.back().first) {
                fail("time codes out of order");
            }
            expect(':');
            result.emplace_back(code, value());
            accept(',');
        }
        return result;
    }

    std::string_view text_;
    std::size_t at_ = 0;
};

}  // namespace

std::vector<double> UsdaValue::numbers() const {
    std::vector<double> result;
    for (const UsdaValue& item : items) {
        if (item.items.empty()) {
            result.push_back(item.number());
        } else {
            const std::vector<double> inner = item.numbers();
            result.insert(result.end(), inner.begin(), inner.end());
        }
    }
    return result;
}

const UsdaPrim* UsdaPrim::child(std::string_view wanted) const {
    const auto found = std::ranges::find(children, wanted, &UsdaPrim::name);
    return found != children.end() ? &*found : nullptr;
}

const UsdaPrim* UsdaPrim::at(std::string_view path) const {
    const UsdaPrim* prim = this;
    while (prim != nullptr && !path.empty()) {
        path.remove_prefix(1);
        const std::size_t end = std::min(path.find('/'), path.size());
        prim = prim->child(path.substr(0, end));
        path.remove_prefix(end);
    }
    return prim;
}

UsdaPrim read_usda(std::string_view text) {
    return Reader(text).file();
}

}  // namespace carom::testing
